// SPDX-License-Identifier: BSD-3-Clause
#include "robust_evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "line_primitive_segmenter.h"
#include "robust_report.h"

namespace line_plane_segmentation {
namespace {

// Two regions of 100 x 50 pixels and, below them, 50 rows of clutter with valid depth.
LabelledFrame twoRegions() {
  LabelledFrame frame;
  frame.name = "a";
  frame.depth = cv::Mat(100, 200, CV_16UC1, cv::Scalar(1000));
  frame.truth = cv::Mat(100, 200, CV_16UC1, cv::Scalar(0));
  frame.truth(cv::Rect(0, 0, 100, 50)).setTo(1);
  frame.truth(cv::Rect(100, 0, 100, 50)).setTo(2);
  frame.camera = {200.0, 200.0, 99.5, 49.5};
  return frame;
}

/// Copies the ground truth, without region 2 where the grid is shifted, and with a label on clutter in a
/// mirror.
class CopyingSegmenter : public FrameSegmenter {
 public:
  int gridSpacing(const LabelledFrame&, const FrameVariant&) const override { return 12; }
  const std::vector<std::uint16_t>& segment(const LabelledFrame& frame,
                                            const FrameVariant& variant) override {
    const std::uint16_t* truth = frame.truthPixels();
    labels_.assign(truth, truth + frame.truth.total());
    for (std::uint16_t& label : labels_) {
      if (label == 65535 || (label == 2 && variant.is_shifted)) label = 0;
    }
    if (variant.orientation == Orientation::kMirrored) labels_.back() = 7;
    return labels_;
  }

 private:
  std::vector<std::uint16_t> labels_;
};

RobustScores evaluateCopies(const std::vector<FrameVariant>& variants) {
  EvaluationSettings settings;
  settings.min_pixels = 5000;
  return evaluateRobustly(
      {twoRegions(), twoRegions()}, variants, [] { return std::make_unique<CopyingSegmenter>(); }, settings);
}

TEST(RobustEvaluation, KnownAnswer) {
  const RobustScores scores = evaluateCopies(allVariants());
  EXPECT_EQ(scores.frames, 2U);
  EXPECT_EQ(scores.variants.size(), 40U);
  ASSERT_EQ(scores.regions.size(), 4U);
  EXPECT_EQ(scores.regions[0].found, 40);
  EXPECT_EQ(scores.regions[1].found, 20);
  EXPECT_EQ(scores.regions[1].correct, 20);
  EXPECT_EQ(scores.regions[1].pixels, 5000);
  // Half of the variants find all regions, half find one of two.
  for (const RobustFigure& figure :
       {scores.correct(), scores.oneToOne(), scores.recall(), scores.covering()}) {
    EXPECT_DOUBLE_EQ(figure.mean, 0.75);
    EXPECT_NEAR(figure.spread, 0.25, 1e-9);
  }
  // A false label beside two or one matches, in a quarter of the variants.
  EXPECT_DOUBLE_EQ(scores.precision().mean, (30.0 + 5.0 * 2.0 / 3.0 + 5.0 * 1.0 / 2.0) / 40.0);
  EXPECT_DOUBLE_EQ(scores.flips(), 0.5);
  EXPECT_DOUBLE_EQ(scores.clutterInPlanes().mean, 0.25 * 1.0 / 10000.0);
}

TEST(RobustEvaluation, CountsRegionsThatComeAndGo) {
  std::vector<FrameVariant> variants(10);
  EXPECT_DOUBLE_EQ(evaluateCopies(variants).flips(), 0.0);
  variants[0].is_shifted = true;  // region 2 is found in 9 of 10 variants
  EXPECT_DOUBLE_EQ(evaluateCopies(variants).flips(), 0.5);
  EXPECT_DOUBLE_EQ(evaluateCopies(variants).uncertain(), 0.0);
  variants[1].is_shifted = true;
  EXPECT_DOUBLE_EQ(evaluateCopies(variants).uncertain(), 0.5);
  for (FrameVariant& variant : variants) variant.is_shifted = true;
  EXPECT_DOUBLE_EQ(evaluateCopies(variants).flips(), 0.0);
}

TEST(RobustEvaluation, ReportsEachSet) {
  const std::vector<NamedRobustScores> sets{{"copies", evaluateCopies(allVariants())}};
  const nlohmann::json document = robustJson(sets, {});
  const nlohmann::json& set = document["sets"].at(0);
  EXPECT_EQ(set["set"], "copies");
  EXPECT_EQ(set["frames"], 2);
  EXPECT_DOUBLE_EQ(set["recall"]["mean"].get<double>(), 0.75);
  EXPECT_DOUBLE_EQ(set["flips"].get<double>(), 0.5);
  EXPECT_EQ(set["regions"].size(), 4U);
  EXPECT_NE(robustTable(sets, {}).find("| 0.750 ± 0.250 |"), std::string::npos);
}

TEST(LinePrimitiveSegmenter, ScalesSpacings) {
  const LabelledFrame frame = twoRegions();
  FrameVariant wide;
  wide.spacing_factor = 14.0 / 12.0;
  Parameters parameters;
  parameters.scanlines.scanline_spacing = 12;
  EXPECT_EQ(LinePrimitiveSegmenter(parameters).gridSpacing(frame, {}), 12);
  EXPECT_EQ(LinePrimitiveSegmenter(parameters).gridSpacing(frame, wide), 14);
}

// An image that is turned, or cropped, has pixels of the same size.
TEST(LinePrimitiveSegmenter, ScalesWhatSuitsTheCamera) {
  LabelledFrame frame;
  frame.camera = {525.0, 525.0, 239.5, 319.5};
  frame.depth = cv::Mat(640, 480, CV_16UC1, cv::Scalar(1500));
  EXPECT_EQ(LinePrimitiveSegmenter(Parameters{}).gridSpacing(frame, {}), 12);
  Parameters paper;
  paper.method = Method::kPaper;
  EXPECT_LT(LinePrimitiveSegmenter(paper).gridSpacing(frame, {}), 30);
}

TEST(LinePrimitiveSegmenter, SegmentsAsThePackageDoes) {
  const LabelledFrame frame = twoRegions();  // one wall in front of the camera
  LinePrimitiveSegmenter segmenter{Parameters{}};
  PlaneSegmenter package;
  for (const double factor : {1.0, 10.0 / 12.0}) {
    FrameVariant variant;
    variant.spacing_factor = factor;
    const std::vector<std::uint16_t> labels = segmenter.segment(frame, variant);
    EXPECT_GT(std::count(labels.begin(), labels.end(), 1), 19000);
    if (factor != 1.0) continue;
    EXPECT_EQ(labels, package.segment(viewOf(frame.depthPixels(), 200, 100), frame.camera).labels);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
