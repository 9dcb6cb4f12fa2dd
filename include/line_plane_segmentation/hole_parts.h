// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Assigns each hole of a plane to the connected part of the plane that contains it: the smallest outer ring
/// that encloses most of the hole's vertices. If simplification has moved all of a hole's vertices out of the
/// outer rings, the hole belongs to the largest part.
/// @param plane  one of segmentation.planes
/// @return index of the part's outer ring per hole, in the order of the rings; 0 is the largest part
std::vector<int> partsOfHoles(const Segmentation& segmentation, const SegmentedPlane& plane);

}  // namespace line_plane_segmentation
