// SPDX-License-Identifier: BSD-3-Clause
#include "iou_scores.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace line_plane_segmentation {
namespace {

double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

IouScores& IouScores::operator+=(const IouScores& other) {
  required += other.required;
  matched += other.matched;
  false_labels += other.false_labels;
  matched_iou_sum += other.matched_iou_sum;
  best_iou_sum += other.best_iou_sum;
  covered_pixels += other.covered_pixels;
  required_pixels += other.required_pixels;
  return *this;
}

double IouScores::precision() const { return ratio(matched, matched + false_labels); }

double IouScores::recall() const { return ratio(matched, required); }

double IouScores::f1() const { return ratio(2.0 * matched, required + matched + false_labels); }

double IouScores::meanIou() const { return ratio(best_iou_sum, required); }

double IouScores::matchedIou() const { return matched == 0 ? 0.0 : matched_iou_sum / matched; }

double IouScores::panopticQuality() const { return f1() * matchedIou(); }

double IouScores::covering() const { return ratio(covered_pixels, static_cast<double>(required_pixels)); }

IouScores scoreIou(const RegionOverlaps& regions, std::int64_t min_pixels) {
  constexpr double kMatch = 0.5;
  std::vector<double> best_iou(regions.truth.size(), 0.0);
  std::vector<bool> label_matched(regions.labels.size(), false);
  for (const Overlap& overlap : regions.overlaps) {
    const std::int64_t joint =
        regions.truth[overlap.truth].pixels + regions.labels[overlap.label].pixels - overlap.pixels;
    const double iou = static_cast<double>(overlap.pixels) / static_cast<double>(joint);
    best_iou[overlap.truth] = std::max(best_iou[overlap.truth], iou);
    if (iou > kMatch) label_matched[overlap.label] = true;
  }

  IouScores scores;
  for (std::size_t i = 0; i < regions.truth.size(); ++i) {
    const std::int64_t pixels = regions.truth[i].pixels;
    if (pixels < min_pixels) continue;
    ++scores.required;
    scores.required_pixels += pixels;
    scores.best_iou_sum += best_iou[i];
    scores.covered_pixels += static_cast<double>(pixels) * best_iou[i];
    if (best_iou[i] > kMatch) {
      ++scores.matched;
      scores.matched_iou_sum += best_iou[i];
    }
  }
  scores.false_labels = static_cast<int>(std::count(label_matched.begin(), label_matched.end(), false));
  return scores;
}

}  // namespace line_plane_segmentation
