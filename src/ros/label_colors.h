// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/ros/conversions.h"
#include "line_plane_segmentation/ros/palette.h"

namespace line_plane_segmentation {

/// The colour of every label of the frame, to be looked up for each pixel; [0] is that of no plane.
inline std::vector<Color> labelColors(const SegmentedFrame& frame, Color no_plane) {
  std::vector<Color> colors(frame.ids.size() + 1, no_plane);
  for (std::size_t k = 0; k < frame.ids.size(); ++k) colors[k + 1] = colorOf(frame.ids[k]);
  return colors;
}

}  // namespace line_plane_segmentation
