// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "robust_evaluation.h"

namespace line_plane_segmentation {

/// A labelled set and the name that reports call it by.
struct NamedSet {
  std::string name;
  std::vector<LabelledFrame> frames;
};

/// Factors by which a parameter is scaled; the default is in the middle.
constexpr std::array<double, 5> kSensitivityFactors = {0.7, 0.85, 1.0, 1.2, 1.4};

/// The figures that are compared, each a mean over the variants.
enum class SensitivityFigure { kCorrect, kRecall, kCovering, kPrecision };
constexpr std::size_t kSensitivityFigures = 4;
const char* nameOf(SensitivityFigure figure);

/// The means of one set by factor, then by figure.
using SetSensitivity = std::array<std::array<double, kSensitivityFigures>, kSensitivityFactors.size()>;

/// How the figures of each set change with one parameter.
struct ParameterSensitivity {
  std::string parameter;
  std::vector<SetSensitivity> sets;

  /// True if a figure of a set differs from the one of the default for any factor.
  bool hasEffect() const;
};

/// Difference between the score at the default of a parameter and the mean of its two neighbours.
struct Prominence {
  double height = 0.0;
  std::size_t set = 0;
  SensitivityFigure figure = SensitivityFigure::kCorrect;
};

/// The largest one over the sets and figures.
Prominence mostProminent(const ParameterSensitivity& parameter);

/// The limit of Prominence::height that every default must keep.
constexpr double kMaxProminence = 0.015;

/// Evaluates the sets with each number among the parameters at each factor. Parameters that are 0 are left
/// out. A parameter that the image's size determines is scaled after it is determined.
std::vector<ParameterSensitivity> evaluateSensitivity(const std::vector<NamedSet>& sets,
                                                      const Parameters& parameters,
                                                      const std::vector<FrameVariant>& variants,
                                                      const EvaluationSettings& settings);

/// Returns the parameters whose default exceeds kMaxProminence, "a, b"; empty if there are none.
std::string namesThatStandOut(const std::vector<ParameterSensitivity>& parameters);

/// All means, by parameter, set, factor and figure.
nlohmann::json sensitivityJson(const std::vector<NamedSet>& sets,
                               const std::vector<ParameterSensitivity>& parameters);

/// A Markdown table: per parameter the change of "correct" in each set, and the most prominent figure.
std::string sensitivityTable(const std::vector<NamedSet>& sets,
                             const std::vector<ParameterSensitivity>& parameters);

}  // namespace line_plane_segmentation
