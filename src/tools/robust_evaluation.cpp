// SPDX-License-Identifier: BSD-3-Clause
#include "robust_evaluation.h"

#include <algorithm>
#include <cmath>

#include "ordered_work.h"

namespace line_plane_segmentation {
namespace {

// Marks the required regions of one frame that are found in one variant. All variants hold the same regions.
void addFound(const RegionOverlaps& regions, const EvaluationSettings& settings,
              std::vector<RegionRecord>& records) {
  for (const Overlap& overlap : regions.overlaps) {
    const CountedRegion& truth = regions.truth[overlap.truth];
    const CountedRegion& label = regions.labels[overlap.label];
    const auto record = std::find_if(records.begin(), records.end(),
                                     [&](const RegionRecord& r) { return r.value == truth.value; });
    if (record == records.end()) continue;
    const auto shared = static_cast<double>(overlap.pixels);
    if (3 * overlap.pixels > truth.pixels + label.pixels) ++record->found;
    if (shared >= settings.tolerance * static_cast<double>(std::max(truth.pixels, label.pixels)))
      ++record->correct;
  }
}

void countClutter(const LabelledFrame& frame, const std::vector<std::uint16_t>& labels,
                  VariantScores& scores) {
  const std::uint16_t *depth = frame.depthPixels(), *truth = frame.truthPixels();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool is_clutter = truth[i] == 0 && depth[i] != 0;
    scores.clutter_pixels += is_clutter ? 1 : 0;
    scores.clutter_pixels_in_planes += is_clutter && labels[i] != 0 ? 1 : 0;
  }
}

/// One frame in all variants.
struct FrameWork {
  const LabelledFrame* frame = nullptr;
  std::unique_ptr<FrameSegmenter> segmenter;
  std::vector<VariantScores> variants;
  std::vector<RegionRecord> regions;

  void evaluate(const std::vector<FrameVariant>& all, const EvaluationSettings& settings) {
    variants.clear();
    regions.clear();
    for (const FrameVariant& variant : all) {
      const LabelledFrame view = viewOf(*frame, variant, *segmenter);
      addVariant(view, segmenter->segment(view, variant), settings);
    }
  }

 private:
  void addVariant(const LabelledFrame& view, const std::vector<std::uint16_t>& labels,
                  const EvaluationSettings& settings) {
    const RegionOverlaps overlaps = countOverlaps(view.truthPixels(), labels.data(), labels.size());
    if (variants.empty()) {
      for (const CountedRegion& region : overlaps.truth) {
        if (region.pixels >= settings.min_pixels)
          regions.push_back({frame->name, region.value, region.pixels});
      }
    }
    addFound(overlaps, settings, regions);
    VariantScores scores;
    scores.scores = scoreOf(EvaluatedFrame{frame->name, overlaps}, settings);
    countClutter(view, labels, scores);
    variants.push_back(scores);
  }
};

void add(const VariantScores& one, VariantScores& sum) {
  sum.scores.hoover += one.scores.hoover;
  sum.scores.iou += one.scores.iou;
  sum.clutter_pixels += one.clutter_pixels;
  sum.clutter_pixels_in_planes += one.clutter_pixels_in_planes;
}

template <typename Figure>
RobustFigure over(const std::vector<VariantScores>& variants, Figure figure) {
  double sum = 0.0, squares = 0.0;
  for (const VariantScores& variant : variants) {
    const double value = figure(variant);
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(variants.size());
  const double mean = sum / n;
  const double variance = squares / n - mean * mean;  // rounding can make it negative
  return {mean, std::sqrt(variance < 0.0 ? 0.0 : variance)};
}

double fraction(double part, double whole) { return whole > 0.0 ? part / whole : std::nan(""); }

// The fraction of the regions for which is_counted(variants that find it, all variants) is true.
template <typename IsCounted>
double fractionFound(const RobustScores& scores, IsCounted is_counted) {
  const auto all = static_cast<int>(scores.variants.size());
  const auto counted =
      std::count_if(scores.regions.begin(), scores.regions.end(),
                    [&](const RegionRecord& region) { return is_counted(region.found, all); });
  return fraction(static_cast<double>(counted), static_cast<double>(scores.regions.size()));
}

}  // namespace

LabelledFrame viewOf(const LabelledFrame& frame, const FrameVariant& variant,
                     const FrameSegmenter& segmenter) {
  const LabelledFrame view = turned(frame, variant.orientation);
  return variant.is_shifted ? shifted(view, segmenter.gridSpacing(view, variant) / 2) : view;
}

RobustFigure RobustScores::correct() const {
  return over(variants, [](const VariantScores& v) {
    return fraction(v.scores.hoover.correct, v.scores.hoover.required);
  });
}

RobustFigure RobustScores::oneToOne() const {
  return over(variants, [](const VariantScores& v) {
    return fraction(v.scores.hoover.one_to_one, v.scores.hoover.required);
  });
}

RobustFigure RobustScores::recall() const {
  return over(variants, [](const VariantScores& v) { return v.scores.iou.recall(); });
}

RobustFigure RobustScores::covering() const {
  return over(variants, [](const VariantScores& v) { return v.scores.iou.covering(); });
}

RobustFigure RobustScores::precision() const {
  return over(variants, [](const VariantScores& v) { return v.scores.iou.precision(); });
}

RobustFigure RobustScores::clutterInPlanes() const {
  return over(variants, [](const VariantScores& v) {
    return fraction(static_cast<double>(v.clutter_pixels_in_planes), static_cast<double>(v.clutter_pixels));
  });
}

double RobustScores::flips() const {
  return fractionFound(*this, [](int found, int all) { return found > 0 && found < all; });
}

double RobustScores::uncertain() const {
  return fractionFound(*this, [](int found, int all) { return 5 * found >= all && 5 * found <= 4 * all; });
}

RobustScores evaluateRobustly(const std::vector<LabelledFrame>& frames,
                              const std::vector<FrameVariant>& variants,
                              const MakeFrameSegmenter& make_segmenter, const EvaluationSettings& settings) {
  RobustScores result;
  result.frames = frames.size();
  result.variants.resize(variants.size());
  std::vector<FrameWork> slots(std::min(slotsForAllCores(), frames.size()));
  for (FrameWork& slot : slots) slot.segmenter = make_segmenter();
  std::size_t next_frame = 0;
  workInOrder(
      slots,
      [&](FrameWork& slot) {
        if (next_frame == frames.size()) return false;
        slot.frame = &frames[next_frame++];
        return true;
      },
      [&](FrameWork& slot) { slot.evaluate(variants, settings); },
      [&](FrameWork& slot) {
        for (std::size_t i = 0; i < variants.size(); ++i) add(slot.variants[i], result.variants[i]);
        result.regions.insert(result.regions.end(), slot.regions.begin(), slot.regions.end());
      });
  return result;
}

}  // namespace line_plane_segmentation
