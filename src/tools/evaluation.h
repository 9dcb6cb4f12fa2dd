// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hoover.h"
#include "iou_scores.h"
#include "region_overlap.h"

namespace line_plane_segmentation {

/// Region overlaps of one frame.
struct EvaluatedFrame {
  std::string name;
  RegionOverlaps regions;
};

/// Computes the region overlaps of every FRAME.png in the folder `truth` with FRAME.labels.png, or FRAME.png,
/// in the folder `labels`, in the order of the names.
/// @throws BadInput if there is no ground-truth image, a label image is missing, or two images differ in size
std::vector<EvaluatedFrame> countFolders(const std::filesystem::path& truth,
                                         const std::filesystem::path& labels);

/// Input and limits of an evaluation.
struct EvaluationSettings {
  std::filesystem::path truth;
  std::filesystem::path labels;
  double tolerance = 0.8;  ///< overlap tolerance of the classification by Hoover et al., above 0.5, at most 1
  std::int64_t min_pixels = 0;  ///< smaller ground-truth regions are not required
};

/// Scores of a frame or a set.
struct Scores {
  HooverCounts hoover;
  IouScores iou;
};

/// Computes the scores of a frame, or of all frames of a set together.
Scores scoreOf(const EvaluatedFrame& frame, const EvaluationSettings& settings);
Scores scoreOf(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings);

/// Classification of a set at one tolerance.
struct CurvePoint {
  double tolerance = 0.0;
  HooverCounts counts;
};

/// Returns the classification at tolerances from just above 0.5 (below which a region could be matched twice)
/// to nearly 1.
std::vector<CurvePoint> toleranceCurve(const std::vector<EvaluatedFrame>& frames, std::int64_t min_pixels);

/// Returns a text table: one line per frame and one for the set.
std::string evaluationTable(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings);

/// Returns the same as JSON, with the curve; null where no region is evaluated.
std::string evaluationJson(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings);

}  // namespace line_plane_segmentation
