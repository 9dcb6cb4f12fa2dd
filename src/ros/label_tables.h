// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/ros/conversions.h"
#include "line_plane_segmentation/ros/palette.h"

namespace line_plane_segmentation {

/// Tables of every label of the frame, to be looked up for each pixel. Labels of planes that are not
/// published have what [0] has, which stands for no plane.

/// The label itself, or 0.
inline std::vector<std::uint16_t> publishedLabels(const SegmentedFrame& frame) {
  std::vector<std::uint16_t> labels(frame.segmentation.planes.size() + 1, 0);
  for (const PublishedPlane& published : frame.published.planes) {
    labels[published.plane.label] = published.plane.label;
  }
  return labels;
}

/// The colour of the plane's id.
inline std::vector<Color> labelColors(const SegmentedFrame& frame, Color no_plane) {
  std::vector<Color> colors(frame.segmentation.planes.size() + 1, no_plane);
  for (const PublishedPlane& published : frame.published.planes) {
    colors[published.plane.label] = colorOf(published.id);
  }
  return colors;
}

}  // namespace line_plane_segmentation
