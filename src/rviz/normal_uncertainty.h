// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/Plane.h>

#include <vector>

#include "polygon_fill.h"

namespace line_plane_segmentation {

/// The uncertainty of a plane's normal as an elliptical disc at the tip of an arrow along it: where the tip
/// would be for a normal that is off by `scale` standard deviations. Empty if the plane has no covariance.
/// @param length  [m] of the arrow from the centroid
std::vector<Triangle> normalDisc(const Plane& plane, float length, float scale);

}  // namespace line_plane_segmentation
