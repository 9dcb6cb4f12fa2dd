// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include "cloud_points.h"

namespace line_plane_segmentation {

sensor_msgs::PointCloud2::Ptr coloredCloud(const SegmentedFrame& frame) {
  const auto width = static_cast<std::size_t>(frame.segmentation.width);
  const auto height = static_cast<std::size_t>(frame.segmentation.height);
  sensor_msgs::PointCloud2::Ptr cloud = makeCloud(frame);
  cloud->is_dense = false;
  cloud->width = static_cast<std::uint32_t>(width);
  cloud->height = static_cast<std::uint32_t>(height);
  cloud->row_step = cloud->width * cloud->point_step;
  cloud->data.resize(height * width * sizeof(CloudPoint));

  CloudRows rows(frame);
  std::uint8_t* out = cloud->data.data();
  for (int v = 0; v < frame.segmentation.height; ++v) {
    rows.load(v);
    for (std::size_t u = 0; u < width; ++u, out += sizeof(CloudPoint)) {
      const CloudPoint point = rows.point(u);
      std::memcpy(out, &point, sizeof point);
    }
  }
  return cloud;
}

}  // namespace line_plane_segmentation
