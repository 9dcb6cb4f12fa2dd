// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation.h"

namespace line_plane_segmentation {

/// The figures of a set of frames that tests hold. All from 0 to 1.
struct QualityFigures {
  double correct = 0.0;     ///< truth regions found as one label region, tolerance 0.8 (Hoover et al. 1996)
  double one_to_one = 0.0;  ///< the same, also where a piece beside it makes it count as over-segmented
  double recall = 0.0;      ///< at IoU 0.5
  double precision = 0.0;   ///< at IoU 0.5
  double covering = 0.0;
};

/// @param min_pixels  truth regions with fewer pixels need not be found
QualityFigures figuresOf(const std::vector<EvaluatedFrame>& frames, std::int64_t min_pixels);

/// One line for people.
std::string toString(const QualityFigures& figures);

/// Fails the running test for each figure under its floor, and prints all of them.
void expectAtLeast(const QualityFigures& floors, const QualityFigures& reached);

}  // namespace line_plane_segmentation
