// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// A plane that was seen. Everything is in the optical frame of the last image.
struct PlaneTrack {
  std::uint32_t id;
  std::uint32_t surface;  ///< planes of one surface share it; one of them has it as its id
  double last_seen;       ///< [s]
  Eigen::Vector3d normal;
  double d;  ///< [m]
  Eigen::Vector3d centroid;
  std::uint32_t pixels;
  std::size_t samples;  ///< that are remembered of it
  int plane;            ///< of this image that it was found to be; -1 = none
};

inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace line_plane_segmentation
