// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "conversions.h"
#include "line_plane_segmentation/palette.h"

namespace line_plane_segmentation {

/// Look-up tables by label. Index 0 is "no plane"; labels of planes that are not published have the same
/// value as index 0.

/// Returns the published label per label: itself, or 0.
inline std::vector<std::uint16_t> publishedLabels(const SegmentedFrame& frame) {
  std::vector<std::uint16_t> labels(frame.segmentation.planes.size() + 1, 0);
  for (const PublishedPlane& published : frame.published.planes) {
    labels[published.plane.label] = published.plane.label;
  }
  return labels;
}

/// Returns the colour per label, which depends on the plane's id.
inline std::vector<Color> labelColors(const SegmentedFrame& frame, Color no_plane) {
  std::vector<Color> colors(frame.segmentation.planes.size() + 1, no_plane);
  for (const PublishedPlane& published : frame.published.planes) {
    colors[published.plane.label] = colorOf(published.id);
  }
  return colors;
}

}  // namespace line_plane_segmentation
