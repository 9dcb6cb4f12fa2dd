// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/palette.h"

namespace line_plane_segmentation {

/// Colour of the pixels of a label.
struct LabelTint {
  bool tinted = false;  ///< false: the pixels stay grey
  Color color;
};

/// Draws a depth image in grey, 60 % of each label's colour over it. Grey falls with 1/z from white at 0.6 m,
/// so that it is independent of the rest of the image and does not flicker in a video. Invalid pixels are
/// black.
/// @param range   depths outside of it are invalid
/// @param labels  one per pixel, row by row; each less than the size of `tints`
/// @param tints   by label; channels are written in the order of Color
/// @param pixels  3 bytes per pixel, row by row
void drawDepthOverlay(const DepthView& depth, const DepthRange& range, const std::uint16_t* labels,
                      const std::vector<LabelTint>& tints, std::uint8_t* pixels);

}  // namespace line_plane_segmentation
