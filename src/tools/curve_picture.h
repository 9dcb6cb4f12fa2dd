// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "evaluation.h"

namespace line_plane_segmentation {

/// Draws how a set's regions were classified over the tolerance, as Hoover et al. plot it: correct, over-
/// segmented, under-segmented and missed as shares of the required truth regions (they add up to 1), noise
/// as a share of the label regions.
/// @param marked_tolerance  where a line is drawn and the values are written out
/// @return 8-bit BGR
cv::Mat drawCurve(const std::vector<CurvePoint>& curve, double marked_tolerance,
                  const HooverCounts& marked_counts);

}  // namespace line_plane_segmentation
