// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace line_plane_segmentation {

/// Local plane at a pixel of a line segment, from which a plane can be extracted.
struct PlaneCandidate {
  int u = 0;                                         ///< [px] column of the pixel
  int v = 0;                                         ///< [px] row of the pixel
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit normal, towards the camera
  double d = 0.0;                                    ///< [m] normal . p + d = 0
  double curvature = 0.0;  ///< ratio of the smallest eigenvalue to the sum of all three, 0 (flat) to 1/3
};

}  // namespace line_plane_segmentation
