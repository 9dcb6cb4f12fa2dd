// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "robust_evaluation.h"

namespace line_plane_segmentation {

/// The scores of a set and the name that reports call it by.
struct NamedRobustScores {
  std::string name;
  RobustScores scores;
};

/// A Markdown table: one row per set with the mean and the spread of each figure.
std::string robustTable(const std::vector<NamedRobustScores>& sets, const EvaluationSettings& settings);

/// The same, and how often each region was found; null where there is nothing to judge.
nlohmann::json robustJson(const std::vector<NamedRobustScores>& sets, const EvaluationSettings& settings);

}  // namespace line_plane_segmentation
