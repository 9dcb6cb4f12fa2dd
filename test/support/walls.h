// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// A parallelogram in the world.
struct Wall {
  Eigen::Vector3d corner, side, other_side;  ///< [m]
  bool there = true;
};

/// A perfect segmentation of an image of walls, and which wall each of its planes is.
struct WallPicture {
  Segmentation segmentation;
  std::vector<std::size_t> wall_of;

  /// Index of the wall's plane, or -1 if it is not seen.
  int planeOf(std::size_t wall) const;
};

/// What a camera sees of them: labels, coefficients, centroids, pixels and areas without any error. The
/// largest plane comes first. Walls of fewer than ten pixels are not seen.
WallPicture pictureOf(const std::vector<Wall>& walls, const Eigen::Isometry3d& camera_in_world,
                      const CameraIntrinsics& camera, int width, int height);

}  // namespace line_plane_segmentation
