// SPDX-License-Identifier: BSD-3-Clause
#include "obstacle_cloud.h"

#include <cmath>
#include <cstring>

#include "cloud_points.h"

namespace line_plane_segmentation {
namespace {

bool isFloor(const SegmentedPlane& plane, const Eigen::Isometry3d& gravity_from_optical,
             const ObstacleParameters& parameters) {
  const double height = (gravity_from_optical * plane.centroid).z();
  return std::abs(height - parameters.floor_height) <= parameters.floor_tolerance;
}

bool isRemoved(const SegmentedPlane& plane, Orientation orientation,
               const Eigen::Isometry3d& gravity_from_optical, const ObstacleParameters& parameters) {
  switch (orientation) {
    case Orientation::kUnknown:
      return false;
    case Orientation::kHorizontalUp:
      return parameters.remove_horizontal_up ||
             (parameters.remove_floor && isFloor(plane, gravity_from_optical, parameters));
    case Orientation::kHorizontalDown:
      return parameters.remove_horizontal_down;
    case Orientation::kVertical:
      return parameters.remove_vertical;
    case Orientation::kSlanted:
      return parameters.remove_slanted;
  }
  return false;
}

}  // namespace

std::vector<bool> removedLabels(const SegmentedFrame& frame, const ObstacleParameters& parameters) {
  const std::vector<SegmentedPlane>& planes = frame.segmentation.planes;
  const FramePoses& poses = frame.published.poses;
  std::vector<bool> removed(planes.size() + 1, !poses.gravity_frame_is_set);
  removed[0] = false;
  if (!poses.gravity_from_optical) return removed;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    removed[k + 1] =
        isRemoved(planes[k], frame.published.orientations[k], *poses.gravity_from_optical, parameters);
  }
  return removed;
}

sensor_msgs::PointCloud2::Ptr cloudWithoutPlanes(const SegmentedFrame& frame,
                                                 const ObstacleParameters& parameters) {
  const std::vector<bool> removed = removedLabels(frame, parameters);
  sensor_msgs::PointCloud2::Ptr cloud = makeCloud(frame);
  cloud->is_dense = true;
  cloud->data.resize(frame.segmentation.labels.size() * sizeof(CloudPoint));

  CloudRows rows(frame);
  std::uint8_t* const begin = cloud->data.data();
  std::uint8_t* out = begin;
  const std::uint16_t* label = frame.segmentation.labels.data();
  for (int v = 0; v < frame.segmentation.height; ++v) {
    rows.load(v);
    for (std::size_t u = 0; u < static_cast<std::size_t>(frame.segmentation.width); ++u, ++label) {
      if (!rows.hasDepth(u) || removed[*label]) continue;
      const CloudPoint point = rows.point(u);
      std::memcpy(out, &point, sizeof point);
      out += sizeof point;
    }
  }
  const auto bytes = static_cast<std::size_t>(out - begin);
  cloud->data.resize(bytes);
  cloud->height = 1;
  cloud->width = static_cast<std::uint32_t>(bytes / sizeof(CloudPoint));
  cloud->row_step = static_cast<std::uint32_t>(bytes);
  return cloud;
}

}  // namespace line_plane_segmentation
