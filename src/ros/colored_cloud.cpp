// SPDX-License-Identifier: BSD-3-Clause
#include <sensor_msgs/point_cloud2_iterator.h>

#include <boost/endian/conversion.hpp>
#include <boost/make_shared.hpp>
#include <cstddef>
#include <limits>
#include <vector>

#include "label_tables.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {
namespace {

constexpr Color kNoPlane{150, 150, 150};

// Colour packed into the bits of a float, as PCL's rgb field has it.
std::uint32_t packed(const Color& color) {
  return static_cast<std::uint32_t>(color.r) << 16 | static_cast<std::uint32_t>(color.g) << 8 | color.b;
}

// x / z per column, computed once for all rows.
std::vector<float> slopesOfColumns(const CameraIntrinsics& camera, int width) {
  std::vector<float> slopes(static_cast<std::size_t>(width));
  for (int u = 0; u < width; ++u) {
    slopes[static_cast<std::size_t>(u)] = static_cast<float>((u - camera.cx) / camera.fx);
  }
  return slopes;
}

}  // namespace

sensor_msgs::PointCloud2::Ptr coloredCloud(const SegmentedFrame& frame) {
  using sensor_msgs::PointField;
  const int width = frame.segmentation.width;
  const int height = frame.segmentation.height;

  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = frame.published.header;
  cloud->is_bigendian = boost::endian::order::native == boost::endian::order::big;
  cloud->is_dense = false;
  sensor_msgs::PointCloud2Modifier modifier(*cloud);
  modifier.setPointCloud2Fields(4, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "rgb", 1, PointField::FLOAT32);
  modifier.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  cloud->width = static_cast<std::uint32_t>(width);
  cloud->height = static_cast<std::uint32_t>(height);
  cloud->row_step = cloud->width * cloud->point_step;
  if (cloud->data.empty()) return cloud;

  const std::vector<Color> colors = labelColors(frame, kNoPlane);
  const std::vector<float> slopes = slopesOfColumns(frame.camera, width);
  std::vector<float> depth(static_cast<std::size_t>(width));
  const std::uint16_t* label = frame.segmentation.labels.data();
  sensor_msgs::PointCloud2Iterator<float> xyz(*cloud, "x");
  sensor_msgs::PointCloud2Iterator<std::uint32_t> rgb(*cloud, "rgb");
  const Eigen::Matrix3f rotation = frame.published.placement.linear().cast<float>();
  const Eigen::Vector3f translation = frame.published.placement.translation().cast<float>();
  for (int v = 0; v < height; ++v) {
    loadRow(frame.depth, v, frame.range, depth.data());
    // The point of a pixel is z (slope_x, slope_y, 1), transformed into the target frame.
    const auto slope_y = static_cast<float>((v - frame.camera.cy) / frame.camera.fy);
    const Eigen::Vector3f row = rotation * Eigen::Vector3f(0.0F, slope_y, 1.0F);
    for (std::size_t u = 0; u < depth.size(); ++u, ++xyz, ++rgb, ++label) {
      const float z = depth[u] > 0.0F ? depth[u] : std::numeric_limits<float>::quiet_NaN();
      const Eigen::Vector3f point = z * (slopes[u] * rotation.col(0) + row) + translation;
      xyz[0] = point.x();
      xyz[1] = point.y();
      xyz[2] = point.z();
      *rgb = packed(colors[*label]);
    }
  }
  return cloud;
}

}  // namespace line_plane_segmentation
