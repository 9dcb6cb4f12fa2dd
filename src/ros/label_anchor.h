// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// A place in the image that a plane fills all around, where a label of it can stand: the middle of the plane
/// may lie behind something, or in a hole.
struct LabelAnchor {
  bool found = false;
  int u = 0;  ///< [px]
  int v = 0;  ///< [px]
};

/// One for each of segmentation.planes: the place nearest to the middle of its pixels that has most of the
/// room that any has. Single missing pixels do not count. Fast, since it looks at about 1 % of the pixels.
std::vector<LabelAnchor> labelAnchors(const Segmentation& segmentation);

}  // namespace line_plane_segmentation
