// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "labelled_set.h"

namespace line_plane_segmentation {

/// Rotation or mirroring of an image.
enum class Orientation { kUpright, kMirrored, kQuarterTurn, kHalfTurn };

/// Variant of a frame: the same planes, with scanlines at other positions.
struct FrameVariant {
  Orientation orientation = Orientation::kUpright;
  double spacing_factor = 1.0;  ///< scanline spacing as a multiple of the default
  bool is_shifted = false;      ///< the grid of scanlines is shifted by half a spacing, in rows and columns
};

/// All 40 variants: four orientations, spacings of 10 to 14 pixels where the default is 12, two grid phases.
std::vector<FrameVariant> allVariants();

/// A smaller set of 8 variants for tests that must be fast: four orientations, spacings of 11 and 13 pixels
/// where the default is 12, one with each grid phase.
std::vector<FrameVariant> fewVariants();

/// Six variants in which planes keep their coefficients: upright, spacings of 10, 12 and 14 pixels where the
/// default is 12, two grid phases.
std::vector<FrameVariant> uprightVariants();

/// Rotates or mirrors depth, ground truth and intrinsics. A quarter turn is clockwise.
LabelledFrame turned(const LabelledFrame& frame, Orientation orientation);

/// Inserts `pixels` rows at the top and columns at the left, with invalid depth and excluded from the
/// evaluation, and shifts the principal point. A grid that starts at the first pixel is thereby shifted
/// relative to the scene, and all evaluated pixels are kept.
LabelledFrame shifted(const LabelledFrame& frame, int pixels);

}  // namespace line_plane_segmentation
