// SPDX-License-Identifier: BSD-3-Clause
#include "sensitivity.h"

#include <algorithm>
#include <boost/format.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "line_primitive_segmenter.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kDefault = 2, kBelow = 1, kAbove = 3;  // indices in kSensitivityFactors

std::array<double, kSensitivityFigures> meansOf(const RobustScores& scores) {
  return {scores.correct().mean, scores.recall().mean, scores.covering().mean, scores.precision().mean};
}

std::array<double, kSensitivityFigures> evaluate(const NamedSet& set, const Parameters& parameters,
                                                 const ScaledParameter& scaled,
                                                 const std::vector<FrameVariant>& variants,
                                                 const EvaluationSettings& settings) {
  const auto make_segmenter = [&] { return std::make_unique<LinePrimitiveSegmenter>(parameters, scaled); };
  return meansOf(evaluateRobustly(set.frames, variants, make_segmenter, settings));
}

}  // namespace

const char* nameOf(SensitivityFigure figure) {
  constexpr std::array<const char*, kSensitivityFigures> kNames = {"correct", "recall", "covering",
                                                                   "precision"};
  return kNames[static_cast<std::size_t>(figure)];
}

bool ParameterSensitivity::hasEffect() const {
  return std::any_of(sets.begin(), sets.end(), [](const SetSensitivity& set) {
    return std::any_of(set.begin(), set.end(), [&set](const auto& means) { return means != set[kDefault]; });
  });
}

Prominence mostProminent(const ParameterSensitivity& parameter) {
  Prominence most;
  most.height = -1.0;
  for (std::size_t s = 0; s < parameter.sets.size(); ++s) {
    const SetSensitivity& set = parameter.sets[s];
    for (std::size_t f = 0; f < kSensitivityFigures; ++f) {
      const double height = set[kDefault][f] - (set[kBelow][f] + set[kAbove][f]) / 2.0;
      if (height > most.height) most = {height, s, static_cast<SensitivityFigure>(f)};
    }
  }
  return most;
}

std::vector<ParameterSensitivity> evaluateSensitivity(const std::vector<NamedSet>& sets,
                                                      const Parameters& parameters,
                                                      const std::vector<FrameVariant>& variants,
                                                      const EvaluationSettings& settings) {
  std::vector<std::array<double, kSensitivityFigures>> defaults;
  for (const NamedSet& set : sets) defaults.push_back(evaluate(set, parameters, {}, variants, settings));

  std::vector<ParameterSensitivity> result;
  for (const std::string& name : scalableParameters(sets.front().frames.front(), parameters)) {
    ParameterSensitivity sensitivity{name, {}};
    for (std::size_t s = 0; s < sets.size(); ++s) {
      SetSensitivity means;
      for (std::size_t f = 0; f < kSensitivityFactors.size(); ++f) {
        const double factor = kSensitivityFactors[f];
        means[f] =
            f == kDefault ? defaults[s] : evaluate(sets[s], parameters, {name, factor}, variants, settings);
      }
      sensitivity.sets.push_back(means);
    }
    result.push_back(sensitivity);
  }
  return result;
}

std::string namesThatStandOut(const std::vector<ParameterSensitivity>& parameters) {
  std::string names;
  for (const ParameterSensitivity& parameter : parameters) {
    if (mostProminent(parameter).height <= kMaxProminence) continue;
    names += (names.empty() ? "" : ", ") + parameter.parameter;
  }
  return names;
}

nlohmann::json sensitivityJson(const std::vector<NamedSet>& sets,
                               const std::vector<ParameterSensitivity>& parameters) {
  nlohmann::json document = nlohmann::json::array();
  for (const ParameterSensitivity& parameter : parameters) {
    for (std::size_t s = 0; s < sets.size(); ++s) {
      for (std::size_t f = 0; f < kSensitivityFactors.size(); ++f) {
        const auto& means = parameter.sets[s][f];
        document.push_back({{"parameter", parameter.parameter},
                            {"set", sets[s].name},
                            {"factor", kSensitivityFactors[f]},
                            {"correct", means[0]},
                            {"recall", means[1]},
                            {"covering", means[2]},
                            {"precision", means[3]}});
      }
    }
  }
  return document;
}

std::string sensitivityTable(const std::vector<NamedSet>& sets,
                             const std::vector<ParameterSensitivity>& parameters) {
  std::ostringstream table;
  table << "Change of correct, in thousandths, at 0.7, 0.85, 1.2 and 1.4 of the default\n\n| parameter |";
  for (const NamedSet& set : sets) table << " " << set.name << " |";
  table << " default above its neighbours |\n|---|";
  for (std::size_t s = 0; s <= sets.size(); ++s) table << "---|";
  table << "\n";
  std::string without_effect;
  for (const ParameterSensitivity& parameter : parameters) {
    if (!parameter.hasEffect()) {
      without_effect += (without_effect.empty() ? "" : ", ") + parameter.parameter;
      continue;
    }
    table << "| " << parameter.parameter << " |";
    for (const SetSensitivity& set : parameter.sets) {
      for (std::size_t f = 0; f < kSensitivityFactors.size(); ++f) {
        if (f != kDefault)
          table << boost::format(" %+d") % std::lround(1000.0 * (set[f][0] - set[kDefault][0]));
      }
      table << " |";
    }
    const Prominence most = mostProminent(parameter);
    table << boost::format(" %.3f (%s, %s)%s |\n") % most.height % sets[most.set].name % nameOf(most.figure) %
                 (most.height > kMaxProminence ? " **stands out**" : "");
  }
  if (!without_effect.empty()) table << "\nWithout effect: " << without_effect << "\n";
  return table.str();
}

}  // namespace line_plane_segmentation
