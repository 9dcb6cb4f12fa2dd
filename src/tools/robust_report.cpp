// SPDX-License-Identifier: BSD-3-Clause
#include "robust_report.h"

#include <boost/format.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace line_plane_segmentation {
namespace {

using nlohmann::json;

std::string text(double value) { return std::isnan(value) ? "-" : (boost::format("%.3f") % value).str(); }

std::string text(const RobustFigure& figure) { return text(figure.mean) + " ± " + text(figure.spread); }

json toJson(const RobustFigure& figure) { return {{"mean", figure.mean}, {"spread", figure.spread}}; }

json toJson(const RegionRecord& region) {
  return {{"frame", region.frame},
          {"value", region.value},
          {"pixels", region.pixels},
          {"found", region.found},
          {"correct", region.correct}};
}

json toJson(const NamedRobustScores& set) {
  const RobustScores& scores = set.scores;
  json result = {{"set", set.name},
                 {"frames", scores.frames},
                 {"variants", scores.variants.size()},
                 {"truth_regions", scores.regions.size()},
                 {"correct", toJson(scores.correct())},
                 {"one_to_one", toJson(scores.oneToOne())},
                 {"recall", toJson(scores.recall())},
                 {"covering", toJson(scores.covering())},
                 {"precision", toJson(scores.precision())},
                 {"clutter_in_planes", toJson(scores.clutterInPlanes())},
                 {"flips", scores.flips()},
                 {"uncertain", scores.uncertain()},
                 {"regions", json::array()}};
  for (const RegionRecord& region : scores.regions) result["regions"].push_back(toJson(region));
  return result;
}

}  // namespace

std::string robustTable(const std::vector<NamedRobustScores>& sets, const EvaluationSettings& settings) {
  std::ostringstream table;
  table << boost::format("Mean ± standard deviation over the variants, tolerance %.3g") % settings.tolerance;
  if (settings.min_pixels > 0) {
    table << ", ground-truth regions of at least " << settings.min_pixels << " pixels";
  }
  table << "\n\n"
           "| set | frames | regions | correct | 1:1 | recall | covering | precision | flips | 20-80 % | "
           "clutter |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [name, scores] : sets) {
    table << boost::format("| %s | %d | %d | %s | %s | %s | %s | %s | %s | %s | %s |\n") % name %
                 scores.frames % scores.regions.size() % text(scores.correct()) % text(scores.oneToOne()) %
                 text(scores.recall()) % text(scores.covering()) % text(scores.precision()) %
                 text(scores.flips()) % text(scores.uncertain()) % text(scores.clutterInPlanes());
  }
  return table.str();
}

json robustJson(const std::vector<NamedRobustScores>& sets, const EvaluationSettings& settings) {
  json document = {
      {"tolerance", settings.tolerance}, {"min_pixels", settings.min_pixels}, {"sets", json::array()}};
  for (const NamedRobustScores& set : sets) document["sets"].push_back(toJson(set));
  return document;
}

}  // namespace line_plane_segmentation
