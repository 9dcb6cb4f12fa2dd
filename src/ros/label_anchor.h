// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Pixel inside a plane, far from its border, at which its text is drawn (an approximate pole of
/// inaccessibility). The plane's centroid may be occluded or lie in a hole.
struct LabelAnchor {
  bool found = false;  ///< false if the plane has no cell in the grid
  int u = 0;           ///< [px]
  int v = 0;           ///< [px]
};

/// Returns one anchor per plane of the segmentation. Among the cells whose distance to the border is at least
/// 80 % of the largest, it is the one nearest to the plane's centroid. Uses a coarse grid that samples about
/// 1 % of the pixels, so single invalid pixels have no effect.
std::vector<LabelAnchor> labelAnchors(const Segmentation& segmentation);

}  // namespace line_plane_segmentation
