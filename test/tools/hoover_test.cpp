// SPDX-License-Identifier: BSD-3-Clause
#include "hoover.h"

#include <gtest/gtest.h>

#include "label_images.h"

namespace line_plane_segmentation {
namespace {

constexpr double kTolerance = 0.8;

HooverCounts classify(const std::vector<Pixels>& pixels, double tolerance = kTolerance, int min_pixels = 0) {
  return classifyRegions(countImages(pixels), tolerance, min_pixels);
}

// correct, over, under, merged, missed, noise
void expectCounts(const HooverCounts& counts, const std::vector<int>& expected) {
  const std::vector<int> found{counts.correct, counts.over_segmented, counts.under_segmented,
                               counts.merged,  counts.missed,         counts.noise};
  EXPECT_EQ(found, expected);
}

TEST(Hoover, EqualImagesAreCorrectWhateverTheLabelsAreCalled) {
  const HooverCounts counts = classify({{1, 7, 100}, {2, 3, 50}, {9, 1, 10}, {0, 0, 40}});
  EXPECT_EQ(counts.required, 3);
  EXPECT_EQ(counts.labels, 3);
  EXPECT_EQ(counts.one_to_one, 3);
  expectCounts(counts, {3, 0, 0, 0, 0, 0});
}

TEST(Hoover, TheToleranceItselfIsEnough) {
  const std::vector<Pixels> found_to_four_fifths{{1, 1, 80}, {1, 0, 20}};
  expectCounts(classify(found_to_four_fifths, 0.8), {1, 0, 0, 0, 0, 0});
  expectCounts(classify(found_to_four_fifths, 0.801), {0, 0, 0, 0, 1, 1});
  const std::vector<Pixels> found_with_a_quarter_too_much{{1, 1, 80}, {0, 1, 20}};
  expectCounts(classify(found_with_a_quarter_too_much, 0.8), {1, 0, 0, 0, 0, 0});
  expectCounts(classify(found_with_a_quarter_too_much, 0.801), {0, 0, 0, 0, 1, 1});
}

TEST(Hoover, OverlapMustBeMutual) {
  expectCounts(classify({{1, 1, 100}, {0, 1, 100}}), {0, 0, 0, 0, 1, 1});
  expectCounts(classify({{1, 1, 100}, {1, 0, 100}}), {0, 0, 0, 0, 1, 1});
}

TEST(Hoover, PiecesOfATruthRegionAreOverSegmentation) {
  expectCounts(classify({{1, 1, 50}, {1, 2, 40}, {1, 0, 10}}), {0, 1, 0, 0, 0, 0});
}

TEST(Hoover, PiecesThatHoldTooLittleTogetherAreNoise) {
  expectCounts(classify({{1, 1, 40}, {1, 2, 39}, {1, 0, 21}}), {0, 0, 0, 0, 1, 2});
}

TEST(Hoover, APieceThatLiesTooFarOutsideIsNone) {
  expectCounts(classify({{1, 1, 50}, {1, 2, 40}, {1, 0, 10}, {0, 2, 11}}), {0, 0, 0, 0, 1, 2});
}

TEST(Hoover, ALabelOverTwoTruthRegionsIsUnderSegmentation) {
  expectCounts(classify({{1, 1, 50}, {2, 1, 40}, {0, 1, 10}}), {0, 0, 1, 2, 0, 0});
  expectCounts(classify({{1, 1, 50}, {2, 1, 40}, {3, 1, 30}, {4, 4, 70}}), {1, 0, 1, 3, 0, 0});
}

TEST(Hoover, TheLargestAverageOverlapDecides) {
  // Correct: (0.9 + 1) / 2. In pieces: (1 + 1 + 0.98) / 3, which is more.
  const HooverCounts in_pieces = classify({{1, 1, 900}, {1, 2, 80}, {1, 0, 20}});
  expectCounts(in_pieces, {0, 1, 0, 0, 0, 0});
  EXPECT_EQ(in_pieces.one_to_one, 1);
  // Correct: (0.95 + 1) / 2. In pieces: (1 + 40/49 + 0.99) / 3, which is less.
  expectCounts(classify({{1, 1, 950}, {1, 2, 40}, {1, 0, 10}, {0, 2, 9}}), {1, 0, 0, 0, 0, 1});
}

TEST(Hoover, OfTwoTruthRegionsTheSmallMayBeSwallowed) {
  // Correct: (1 + 0.9) / 2. Merged: (1 + 1 + 1) / 3.
  expectCounts(classify({{1, 1, 900}, {2, 1, 100}}), {0, 0, 1, 2, 0, 0});
  // Half of the small one is swallowed: it is missed, the large one correct.
  expectCounts(classify({{1, 1, 900}, {2, 1, 50}, {2, 0, 50}}), {1, 0, 0, 0, 1, 0});
}

TEST(Hoover, PixelsNotToBeJudgedAreInNeitherImage) {
  expectCounts(classify({{1, 1, 100}, {kDoNotJudge, 1, 500}}), {1, 0, 0, 0, 0, 0});
  const HooverCounts nothing = classify({{kDoNotJudge, 1, 500}, {kDoNotJudge, 0, 10}});
  EXPECT_EQ(nothing.required, 0);
  EXPECT_EQ(nothing.labels, 0);
  expectCounts(nothing, {0, 0, 0, 0, 0, 0});
}

TEST(Hoover, WhatLiesMostlyOnPixelsNotToBeJudgedIsNoPieceOfItsSurroundings) {
  const std::vector<Pixels> table_with_the_fringe_of_a_cup{{1, 1, 950}, {1, 2, 50}, {kDoNotJudge, 2, 400}};
  expectCounts(classify(table_with_the_fringe_of_a_cup), {1, 0, 0, 0, 0, 0});
  const std::vector<Pixels> table_with_a_false_piece{{1, 1, 950}, {1, 2, 50}, {kDoNotJudge, 2, 40}};
  expectCounts(classify(table_with_a_false_piece), {0, 1, 0, 0, 0, 0});
}

TEST(Hoover, SmallTruthRegionsAreNotRequired) {
  const std::vector<Pixels> small_one_found{{1, 1, 100}, {2, 2, 10}};
  const HooverCounts counts = classify(small_one_found, kTolerance, 11);
  EXPECT_EQ(counts.required, 1);
  expectCounts(counts, {1, 0, 0, 0, 0, 0});
  EXPECT_EQ(classify(small_one_found, kTolerance, 10).required, 2);

  const std::vector<Pixels> small_one_missed{{1, 1, 100}, {2, 0, 10}};
  expectCounts(classify(small_one_missed, kTolerance, 11), {1, 0, 0, 0, 0, 0});
  const std::vector<Pixels> small_one_swallowed{{1, 1, 100}, {2, 1, 10}};
  expectCounts(classify(small_one_swallowed, kTolerance, 11), {1, 0, 0, 0, 0, 0});
  const std::vector<Pixels> small_one_hardly_found{{1, 1, 100}, {2, 2, 10}, {0, 2, 90}};
  expectCounts(classify(small_one_hardly_found, kTolerance, 11), {1, 0, 0, 0, 0, 1});
}

TEST(Hoover, NothingToFindOrNothingFound) {
  expectCounts(classify({{0, 0, 10}}), {0, 0, 0, 0, 0, 0});
  expectCounts(classify({{0, 1, 10}}), {0, 0, 0, 0, 0, 1});
  expectCounts(classify({{1, 0, 10}}), {0, 0, 0, 0, 1, 0});
  expectCounts(classify({}), {0, 0, 0, 0, 0, 0});
}

TEST(Hoover, CountsAddUpOverFrames) {
  HooverCounts sum = classify({{1, 1, 50}, {1, 2, 50}, {2, 0, 10}, {0, 3, 10}});
  sum += classify({{1, 1, 50}, {2, 1, 50}, {3, 3, 10}});
  EXPECT_EQ(sum.required, 5);
  EXPECT_EQ(sum.labels, 5);
  EXPECT_EQ(sum.one_to_one, 1);
  expectCounts(sum, {1, 1, 1, 2, 1, 1});
}

}  // namespace
}  // namespace line_plane_segmentation
