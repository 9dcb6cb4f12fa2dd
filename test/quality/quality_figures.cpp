// SPDX-License-Identifier: BSD-3-Clause
#include "quality_figures.h"

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <sstream>

namespace line_plane_segmentation {

QualityFigures figuresOf(const std::vector<EvaluatedFrame>& frames, std::int64_t min_pixels) {
  EvaluationSettings settings;
  settings.min_pixels = min_pixels;
  const Scores scores = scoreOf(frames, settings);
  const auto share = [&](int count) { return static_cast<double>(count) / scores.hoover.required; };
  return {share(scores.hoover.correct), share(scores.hoover.one_to_one), scores.iou.recall(),
          scores.iou.precision(), scores.iou.covering()};
}

std::string toString(const QualityFigures& figures) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "correct " << figures.correct << ", one to one "
       << figures.one_to_one << ", recall " << figures.recall << ", precision " << figures.precision
       << ", covering " << figures.covering;
  return text.str();
}

void expectAtLeast(const QualityFigures& floors, const QualityFigures& reached) {
  std::cout << "reached: " << toString(reached) << "\nfloors:  " << toString(floors) << std::endl;
  EXPECT_GE(reached.correct, floors.correct);
  EXPECT_GE(reached.one_to_one, floors.one_to_one);
  EXPECT_GE(reached.recall, floors.recall);
  EXPECT_GE(reached.precision, floors.precision);
  EXPECT_GE(reached.covering, floors.covering);
}

}  // namespace line_plane_segmentation
