// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/format.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "evaluation.h"

namespace line_plane_segmentation {
namespace {

using nlohmann::json;

// NaN, which JSON shows as null, of nothing.
double fraction(int part, int whole) { return whole == 0 ? std::nan("") : static_cast<double>(part) / whole; }

std::string rate(double value) { return std::isnan(value) ? "-" : (boost::format("%.3f") % value).str(); }

std::string tableLine(const std::string& name, std::size_t name_width, const Scores& scores) {
  const HooverCounts& h = scores.hoover;
  const IouScores& i = scores.iou;
  std::ostringstream line;
  line << name << std::string(name_width - name.size(), ' ')
       << boost::format(" %6d %6d | %7d %5d %5d %6d %5d") % h.required % h.labels % h.correct %
              h.over_segmented % h.under_segmented % h.missed % h.noise
       << boost::format(" | %7s %5s %9s %6s %5s %5s %5s %8s\n") % rate(fraction(h.correct, h.required)) %
              rate(fraction(h.one_to_one, h.required)) % rate(i.precision()) % rate(i.recall()) %
              rate(i.f1()) % rate(i.meanIou()) % rate(i.panopticQuality()) % rate(i.covering());
  return line.str();
}

json hooverToJson(const HooverCounts& counts) {
  return {{"truth_regions", counts.required},
          {"label_regions", counts.labels},
          {"correct", counts.correct},
          {"over_segmented", counts.over_segmented},
          {"under_segmented", counts.under_segmented},
          {"merged", counts.merged},
          {"missed", counts.missed},
          {"noise", counts.noise},
          {"one_to_one", counts.one_to_one},
          {"correct_rate", fraction(counts.correct, counts.required)},
          {"one_to_one_rate", fraction(counts.one_to_one, counts.required)}};
}

json scoresToJson(const Scores& scores) {
  json result = hooverToJson(scores.hoover);
  result.update(json{{"precision", scores.iou.precision()},
                     {"recall", scores.iou.recall()},
                     {"f1", scores.iou.f1()},
                     {"mean_iou", scores.iou.meanIou()},
                     {"matched_iou", scores.iou.matchedIou()},
                     {"pq", scores.iou.panopticQuality()},
                     {"covering", scores.iou.covering()}});
  return result;
}

}  // namespace

std::string evaluationTable(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings) {
  const std::string total = "all " + std::to_string(frames.size()) + " frames";
  std::size_t width = total.size();
  for (const EvaluatedFrame& frame : frames) width = std::max(width, frame.name.size());

  std::ostringstream table;
  table << boost::format("labels %s, truth %s, tolerance %.3g") % settings.labels.string() %
               settings.truth.string() % settings.tolerance;
  if (settings.min_pixels > 0) table << ", truth regions from " << settings.min_pixels << " pixels";
  const std::string blank(width, ' ');
  const std::string rule = std::string(width, '-') + std::string(111, '-') + "\n";
  table << "\n\n"
        << blank
        << "    regions    |      Hoover et al. (1996), regions  |         rates; matches from IoU 0.5\n"
        << "frame" << std::string(width - 5, ' ')
        << "  truth labels | correct  over under missed noise | correct   1:1 precision recall    F1  mIoU   "
           " PQ "
           "covering\n"
        << rule;
  for (const EvaluatedFrame& frame : frames) table << tableLine(frame.name, width, scoreOf(frame, settings));
  table << rule << tableLine(total, width, scoreOf(frames, settings));
  return table.str();
}

std::string evaluationJson(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings) {
  json document = {{"truth", settings.truth.string()},
                   {"labels", settings.labels.string()},
                   {"tolerance", settings.tolerance},
                   {"min_pixels", settings.min_pixels},
                   {"set", scoresToJson(scoreOf(frames, settings))},
                   {"frames", json::array()},
                   {"curve", json::array()}};
  for (const EvaluatedFrame& frame : frames) {
    json scores = scoresToJson(scoreOf(frame, settings));
    scores["frame"] = frame.name;
    document["frames"].push_back(scores);
  }
  for (const CurvePoint& point : toleranceCurve(frames, settings.min_pixels)) {
    json counts = hooverToJson(point.counts);
    counts["tolerance"] = point.tolerance;
    document["curve"].push_back(counts);
  }
  return document.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace line_plane_segmentation
