// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/orientation.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

namespace line_plane_segmentation {

const char* nameOf(Orientation orientation) {
  constexpr std::array<const char*, kOrientationCount> kNames = {"unknown", "horizontal_up",
                                                                 "horizontal_down", "vertical", "slanted"};
  return kNames[static_cast<std::size_t>(orientation)];
}

Orientation orientationOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& up, double tolerance) {
  // The arc tangent is exact at every angle, the arc cosine is not near 0.
  const double along = normal.dot(up);
  const double across = normal.cross(up).norm();
  if (std::atan2(across, std::abs(along)) <= tolerance) {
    return along > 0.0 ? Orientation::kHorizontalUp : Orientation::kHorizontalDown;
  }
  return std::atan2(std::abs(along), across) <= tolerance ? Orientation::kVertical : Orientation::kSlanted;
}

}  // namespace line_plane_segmentation
