// SPDX-License-Identifier: BSD-3-Clause
#include "quality_figures.h"

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <sstream>

#include "line_primitive_segmenter.h"

namespace line_plane_segmentation {
namespace {

std::string toString(const QualityFigures& figures) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "correct " << figures.correct << ", one to one "
       << figures.one_to_one << ", recall " << figures.recall << ", precision " << figures.precision
       << ", covering " << figures.covering;
  return text.str();
}

}  // namespace

bool isAsRecorded(const FrameVariant& variant) {
  return variant.orientation == Orientation::kUpright && variant.spacing_factor == 1.0 && !variant.is_shifted;
}

RobustScores evaluateFew(const std::vector<LabelledFrame>& frames, const Parameters& parameters,
                         std::int64_t min_pixels) {
  EvaluationSettings settings;
  settings.min_pixels = min_pixels;
  const auto make_segmenter = [&] { return std::make_unique<LinePrimitiveSegmenter>(parameters); };
  return evaluateRobustly(frames, fewVariants(), make_segmenter, settings);
}

void expectAtLeast(const QualityFigures& floors, const RobustScores& scores) {
  const QualityFigures reached{scores.correct().mean, scores.oneToOne().mean, scores.recall().mean,
                               scores.precision().mean, scores.covering().mean};
  std::cout << "reached: " << toString(reached) << "\nfloors:  " << toString(floors) << std::endl;
  EXPECT_GE(reached.correct, floors.correct);
  EXPECT_GE(reached.one_to_one, floors.one_to_one);
  EXPECT_GE(reached.recall, floors.recall);
  EXPECT_GE(reached.precision, floors.precision);
  EXPECT_GE(reached.covering, floors.covering);
}

}  // namespace line_plane_segmentation
