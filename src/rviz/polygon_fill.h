// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/Plane.h>

#include <Eigen/Core>
#include <array>
#include <vector>

namespace line_plane_segmentation {

using Triangle = std::array<Eigen::Vector3f, 3>;

/// Divides the visible part of a plane, its outline and other parts without the holes, into triangles on the
/// plane. Vertices are rounded to 0.1 mm. Polygons with coordinates beyond 100 km or not finite give no
/// triangles.
std::vector<Triangle> fillOf(const Plane& plane);

}  // namespace line_plane_segmentation
