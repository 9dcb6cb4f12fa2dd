// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Assigns each hole of a plane to the connected part of the plane that it lies in: the smallest outer ring
/// that encloses most of the hole's vertices. A hole of which no outer ring encloses a vertex, as simplified
/// rings may leave it, belongs to the largest part.
/// @param plane  one of segmentation.planes
/// @return for each hole, in the order of the rings, the index of its part's outer ring among the plane's: 0
/// is
///         the largest part
std::vector<int> partsOfHoles(const Segmentation& segmentation, const SegmentedPlane& plane);

}  // namespace line_plane_segmentation
