// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// What the outline of a label has to enclose, found pixel by pixel.
struct ReferenceOutline {
  std::vector<double> part_areas, hole_areas;  ///< [px] that their borders enclose, the largest first
  std::vector<std::uint8_t> inside;            ///< 1 for each pixel in an odd number of them
  bool has_touching_corners = false;           ///< somewhere two pixels touch at a corner and nowhere near it
};

/// Parts are 4-connected, holes 8-connected; those that enclose fewer than `min_area` pixels are left out,
/// except for the largest part.
ReferenceOutline referenceOutline(const Segmentation& segmentation, int label, int min_area);

/// Distance [px] from the centre of pixel (u, v) to the nearest crack between a pixel of the label and
/// another.
double distanceToBorder(const Segmentation& segmentation, int label, int u, int v);

}  // namespace line_plane_segmentation
