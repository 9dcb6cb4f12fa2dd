// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "robust_evaluation.h"

namespace line_plane_segmentation {

/// The figures of a set of frames that tests hold: means over fewVariants(), all from 0 to 1.
struct QualityFigures {
  double correct = 0.0;     ///< truth regions found as one label region, tolerance 0.8 (Hoover et al. 1996)
  double one_to_one = 0.0;  ///< truth regions with a label region of that mutual overlap
  double recall = 0.0;      ///< at IoU 0.5
  double precision = 0.0;   ///< at IoU 0.5
  double covering = 0.0;
};

/// Whether a variant has the default spacing and phase of the scanlines, on the frame as it is.
bool isAsRecorded(const FrameVariant& variant);

/// Evaluates this package's method in fewVariants().
/// @param min_pixels  truth regions with fewer pixels need not be found
RobustScores evaluateFew(const std::vector<LabelledFrame>& frames, const Parameters& parameters,
                         std::int64_t min_pixels);

/// Fails the running test for each mean under its floor, and prints all of them.
void expectAtLeast(const QualityFigures& floors, const RobustScores& reached);

}  // namespace line_plane_segmentation
