// SPDX-License-Identifier: BSD-3-Clause
#include "iou_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "label_images.h"

namespace line_plane_segmentation {
namespace {

IouScores score(const std::vector<Pixels>& pixels, int min_pixels = 0) {
  return scoreIou(countImages(pixels), min_pixels);
}

TEST(RegionOverlap, CountsRegionsAndWhatTheyShare) {
  const RegionOverlaps regions =
      countImages({{5, 2, 10}, {5, 0, 3}, {0, 2, 4}, {7, 9, 1}, {kDoNotJudge, 9, 8}, {0, 0, 6}});
  ASSERT_EQ(regions.truth.size(), 2U);
  EXPECT_EQ(regions.truth[0].value, 5);
  EXPECT_EQ(regions.truth[0].pixels, 13);
  EXPECT_EQ(regions.truth[1].value, 7);
  EXPECT_EQ(regions.truth[1].pixels, 1);
  ASSERT_EQ(regions.labels.size(), 2U);
  EXPECT_EQ(regions.labels[0].value, 2);
  EXPECT_EQ(regions.labels[0].pixels, 14);
  EXPECT_EQ(regions.labels[1].value, 9);
  EXPECT_EQ(regions.labels[1].pixels, 1);
  ASSERT_EQ(regions.overlaps.size(), 2U);
  EXPECT_EQ(regions.overlaps[0].truth, 0U);
  EXPECT_EQ(regions.overlaps[0].label, 0U);
  EXPECT_EQ(regions.overlaps[0].pixels, 10);
  EXPECT_EQ(regions.overlaps[1].truth, 1U);
  EXPECT_EQ(regions.overlaps[1].label, 1U);
  EXPECT_EQ(regions.overlaps[1].pixels, 1);
}

TEST(RegionOverlap, TheFringeOfWhatIsNotJudgedIsNoRegion) {
  const auto label_regions = [](int in_truth, int nowhere, int not_judged) {
    return countImages(
               {{1, 0, 100 - in_truth}, {1, 2, in_truth}, {0, 2, nowhere}, {kDoNotJudge, 2, not_judged}})
        .labels.size();
  };
  EXPECT_EQ(label_regions(10, 5, 15), 1U);
  EXPECT_EQ(label_regions(10, 5, 16), 0U);
  EXPECT_EQ(label_regions(0, 5, 6), 0U);
  EXPECT_EQ(label_regions(50, 5, 500), 0U);
  EXPECT_EQ(label_regions(51, 5, 500), 1U);
  EXPECT_TRUE(countImages({{1, 2, 10}, {1, 0, 90}, {kDoNotJudge, 2, 11}}).overlaps.empty());
}

TEST(IouScores, PerfectIsOneThroughout) {
  const IouScores scores = score({{1, 4, 30}, {2, 5, 20}, {0, 0, 10}, {kDoNotJudge, 5, 100}});
  EXPECT_DOUBLE_EQ(scores.precision(), 1.0);
  EXPECT_DOUBLE_EQ(scores.recall(), 1.0);
  EXPECT_DOUBLE_EQ(scores.f1(), 1.0);
  EXPECT_DOUBLE_EQ(scores.meanIou(), 1.0);
  EXPECT_DOUBLE_EQ(scores.matchedIou(), 1.0);
  EXPECT_DOUBLE_EQ(scores.panopticQuality(), 1.0);
  EXPECT_DOUBLE_EQ(scores.covering(), 1.0);
}

// Truth 1 (100 pixels): label 1 with 80 of them and 20 others, IoU 80/120. Truth 2 (60): label 2 with 20 of
// them, IoU 20/60. Truth 3 (40): nothing. Label 3 lies nowhere.
const std::vector<Pixels> kMixed{{1, 1, 80}, {1, 0, 20}, {0, 1, 20}, {2, 2, 20},
                                 {2, 0, 40}, {3, 0, 40}, {0, 3, 5}};

TEST(IouScores, KnownAnswer) {
  const IouScores scores = score(kMixed);
  EXPECT_EQ(scores.required, 3);
  EXPECT_EQ(scores.matched, 1);
  EXPECT_EQ(scores.false_labels, 2);
  EXPECT_DOUBLE_EQ(scores.precision(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(scores.recall(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(scores.f1(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(scores.meanIou(), (80.0 / 120.0 + 20.0 / 60.0 + 0.0) / 3.0);
  EXPECT_DOUBLE_EQ(scores.matchedIou(), 80.0 / 120.0);
  EXPECT_DOUBLE_EQ(scores.panopticQuality(), 80.0 / 120.0 / 3.0);
  EXPECT_DOUBLE_EQ(scores.covering(), (100 * 80.0 / 120.0 + 60 * 20.0 / 60.0) / 200.0);
}

TEST(IouScores, HalfIsNoMatchYet) {
  EXPECT_EQ(score({{1, 1, 50}, {1, 0, 50}}).matched, 0);
  EXPECT_EQ(score({{1, 1, 50}, {1, 2, 50}}).matched, 0);
  EXPECT_EQ(score({{1, 1, 51}, {1, 0, 49}}).matched, 1);
}

TEST(IouScores, SmallTruthRegionsCountNeitherForNorAgainst) {
  const std::vector<Pixels> with_small_one_found{{1, 1, 100}, {2, 2, 10}};
  const IouScores scores = score(with_small_one_found, 11);
  EXPECT_EQ(scores.required, 1);
  EXPECT_EQ(scores.matched, 1);
  EXPECT_EQ(scores.false_labels, 0);
  EXPECT_EQ(scores.required_pixels, 100);
  EXPECT_EQ(score(with_small_one_found, 10).required, 2);

  const IouScores hardly_found = score({{1, 1, 100}, {2, 2, 10}, {0, 2, 10}}, 11);
  EXPECT_EQ(hardly_found.false_labels, 1);
}

TEST(IouScores, WhereThereIsNothingToJudgeThereIsNoScore) {
  const IouScores nothing = score({{0, 0, 10}});
  EXPECT_TRUE(std::isnan(nothing.precision()));
  EXPECT_TRUE(std::isnan(nothing.recall()));
  EXPECT_TRUE(std::isnan(nothing.f1()));
  EXPECT_TRUE(std::isnan(nothing.meanIou()));
  EXPECT_TRUE(std::isnan(nothing.panopticQuality()));
  EXPECT_TRUE(std::isnan(nothing.covering()));

  const IouScores nothing_found = score({{1, 0, 10}});
  EXPECT_TRUE(std::isnan(nothing_found.precision()));
  EXPECT_DOUBLE_EQ(nothing_found.recall(), 0.0);
  EXPECT_DOUBLE_EQ(nothing_found.panopticQuality(), 0.0);
  EXPECT_DOUBLE_EQ(nothing_found.covering(), 0.0);
}

TEST(IouScores, AddUpOverFrames) {
  IouScores sum = score(kMixed);
  sum += score({{1, 1, 100}});
  EXPECT_DOUBLE_EQ(sum.precision(), 2.0 / 4.0);
  EXPECT_DOUBLE_EQ(sum.recall(), 2.0 / 4.0);
  EXPECT_DOUBLE_EQ(sum.meanIou(), (80.0 / 120.0 + 20.0 / 60.0 + 0.0 + 1.0) / 4.0);
  EXPECT_DOUBLE_EQ(sum.matchedIou(), (80.0 / 120.0 + 1.0) / 2.0);
  EXPECT_DOUBLE_EQ(sum.covering(), (100 * 80.0 / 120.0 + 60 * 20.0 / 60.0 + 100.0) / 300.0);
}

}  // namespace
}  // namespace line_plane_segmentation
