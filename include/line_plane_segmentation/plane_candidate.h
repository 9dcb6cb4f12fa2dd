// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace line_plane_segmentation {

/// A local plane at one point of a line segment, where the extraction may start.
struct PlaneCandidate {
  int u = 0;                                         ///< [px] column of the pixel that it starts from
  int v = 0;                                         ///< [px] row
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, toward the camera
  double d = 0.0;                                    ///< [m] normal . p + d = 0
  double curvature = 0.0;  ///< smallest eigenvalue over the sum of all three, 0 (flat) to 1/3
};

}  // namespace line_plane_segmentation
