// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hoover.h"
#include "iou_scores.h"
#include "region_overlap.h"

namespace line_plane_segmentation {

/// The images of one frame, counted.
struct EvaluatedFrame {
  std::string name;
  RegionOverlaps regions;
};

/// Counts every FRAME.png of the folder `truth` against FRAME.labels.png, or else FRAME.png, of the folder
/// `labels`, in the order of the names.
/// @throws BadInput if there is no truth image, one has no labels, or two images differ in size
std::vector<EvaluatedFrame> countFolders(const std::filesystem::path& truth,
                                         const std::filesystem::path& labels);

/// What is measured how.
struct EvaluationSettings {
  std::filesystem::path truth;
  std::filesystem::path labels;
  double tolerance = 0.8;       ///< of the classification after Hoover et al.
  std::int64_t min_pixels = 0;  ///< smaller truth regions are not required
};

/// All scores of a frame or a set.
struct Scores {
  HooverCounts hoover;
  IouScores iou;
};

/// The scores of a frame, or of all of a set together.
Scores scoreOf(const EvaluatedFrame& frame, const EvaluationSettings& settings);
Scores scoreOf(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings);

/// The classification of a set at one of many tolerances.
struct CurvePoint {
  double tolerance = 0.0;
  HooverCounts counts;
};

/// From just above 0.5, where a region could be matched twice, to nearly 1.
std::vector<CurvePoint> toleranceCurve(const std::vector<EvaluatedFrame>& frames, std::int64_t min_pixels);

/// The table for people: a line for each frame and one for the set.
std::string evaluationTable(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings);

/// The same as JSON, with the curve; null where there is nothing to judge.
std::string evaluationJson(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings);

}  // namespace line_plane_segmentation
