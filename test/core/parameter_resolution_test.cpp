// SPDX-License-Identifier: BSD-3-Clause
// What resolve() makes of an image's width; the rest of parameters.h is tested in parameters_test.cpp.
#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "support/resolved_parameters.h"

namespace line_plane_segmentation {
namespace {

/// The parameters that follow the image's width, the paper's first.
std::vector<int> automaticValues(const Parameters& p) {
  return {p.scanlines.scanline_spacing,   p.lines.line_window,
          p.lines.min_line_points,        p.candidates.normal_window,
          p.candidates.min_window_points, p.extraction.min_plane_inliers,
          p.cleanup.min_region_pixels};
}

std::vector<int> valuesOfThePaper(int width) {
  std::vector<int> values = automaticValues(paperParameters(width));
  values.resize(6);
  return values;
}

TEST(Resolve, GivesThePapersTable) {
  EXPECT_EQ(valuesOfThePaper(640), (std::vector<int>{30, 11, 30, 20, 240, 5000}));
  EXPECT_EQ(valuesOfThePaper(320), (std::vector<int>{20, 7, 23, 20, 240, 1000}));
  for (const int width : {320, 640}) {
    EXPECT_EQ(paperParameters(width).extraction.plane_distance, 0.02);
    EXPECT_EQ(paperParameters(width).extraction.neighbor_distance, 0.03);
  }
}

TEST(Resolve, ScansMoreCloselyByDefaultThanThePaper) {
  const ScanlineParameters vga = resolve(Parameters{}, 640).scanlines,
                           qvga = resolve(Parameters{}, 320).scanlines;
  EXPECT_EQ(vga.scanline_spacing, 12);
  EXPECT_EQ(qvga.scanline_spacing, 10);
}

TEST(Resolve, HasWindowsThatMakeALineAtEveryWidth) {
  for (int width = 1; width <= 64; ++width) {
    EXPECT_GE(resolve(Parameters{}, width).lines.line_window, 3) << width;
    EXPECT_GE(paperParameters(width).lines.line_window, 5) << width;
  }
}

TEST(Resolve, SuitsThePapersMethodAtEveryWidth) {
  for (int width = 160; width <= 1920; ++width) {
    const Parameters p = paperParameters(width);
    const int window = p.candidates.normal_window;
    EXPECT_GE(width / p.scanlines.scanline_spacing, 15) << width;
    EXPECT_LE(width / p.scanlines.scanline_spacing, 22) << width;
    EXPECT_EQ(p.lines.line_window % 2, 1) << width;
    EXPECT_GE(p.lines.min_line_points, p.lines.line_window + 2) << "three windows fit at " << width;
    EXPECT_LE(p.lines.min_line_points, width / 12) << width;
    EXPECT_GE(window, 10) << width;
    EXPECT_LE(p.candidates.min_window_points, window * window) << width;
    EXPECT_GE(p.candidates.min_window_points, window * window / 2) << width;
    const double image_fraction = p.extraction.min_plane_inliers / (0.75 * width * width);
    EXPECT_GT(image_fraction, 0.01) << width;
    EXPECT_LT(image_fraction, 0.02) << width;
  }
}

class ResolveForMethod : public testing::TestWithParam<Method> {
 protected:
  Parameters at(int width) const {
    Parameters parameters;
    parameters.method = GetParam();
    return resolve(parameters, width);
  }
};

TEST_P(ResolveForMethod, NeverFallsAsTheWidthGrows) {
  std::vector<int> previous = automaticValues(at(160));
  for (int width = 161; width <= 1920; ++width) {
    const std::vector<int> values = automaticValues(at(width));
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_GE(values[i], previous[i]) << width << ", parameter " << i;
    previous = values;
  }
}

TEST_P(ResolveForMethod, LooksAtTheSamePartOfAWiderView) {
  const std::vector<int> vga = automaticValues(at(640)), twice = automaticValues(at(1280));
  for (const std::size_t length : {0U, 1U, 2U, 3U}) EXPECT_NEAR(twice[length], 2 * vga[length], 1) << length;
  for (const std::size_t area : {4U, 5U, 6U}) EXPECT_NEAR(twice[area], 4 * vga[area], 1) << area;
}

TEST_P(ResolveForMethod, LeavesWhatIsGiven) {
  Parameters given;
  given.method = GetParam();
  given.scanlines.scanline_spacing = 3;
  given.lines.line_window = 5;
  given.lines.min_line_points = 7;
  given.candidates.normal_window = 9;
  given.candidates.min_window_points = 11;
  given.extraction.min_plane_inliers = 13;
  given.cleanup.min_region_pixels = 15;
  for (const int width : {160, 320, 640, 1920}) {
    EXPECT_EQ(automaticValues(resolve(given, width)), automaticValues(given)) << width;
  }
}

TEST_P(ResolveForMethod, DoneTwiceIsDoneOnce) {
  for (const int width : {160, 320, 500, 640, 1280, 1920}) {
    EXPECT_EQ(automaticValues(resolve(at(width), width)), automaticValues(at(width))) << width;
  }
}

TEST_P(ResolveForMethod, LeavesNothingAutomaticEvenAtNoWidth) {
  for (const int width : {-5, 0, 1, 2, 20}) {
    for (const int value : automaticValues(at(width))) EXPECT_GE(value, 1) << width;
  }
}

// What goes with the square of the width is more than an int holds.
TEST_P(ResolveForMethod, KeepsTheCountsOfTheWidestImagesPositive) {
  for (const int width : {1'000'000, 3'482'621, 1 << 24, std::numeric_limits<int>::max()}) {
    for (const int value : automaticValues(at(width))) EXPECT_GE(value, 1) << width;
  }
}

TEST_P(ResolveForMethod, StaysWithinTheBounds) {
  for (const int width : {1, 160, 320, 640, 1920}) {
    Parameters p = at(width);
    EXPECT_TRUE(sanitize(p).empty()) << width;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, ResolveForMethod, testing::Values(Method::kPaper, Method::kAdaptive),
                         [](const auto& method) {
                           return method.param == Method::kPaper ? "Paper" : "Adaptive";
                         });

TEST(Resolve, TakesWindowPointsFromAGivenWindow) {
  Parameters given;
  given.candidates.normal_window = 10;
  EXPECT_EQ(resolve(given, 640).candidates.min_window_points, 60);
}

TEST(Resolve, GivesTheDefaultsOfTheDefaultMethod) {
  const auto values_at = [](int width) {
    const Parameters p = adaptiveParameters(width);
    return std::vector<int>{p.scanlines.scanline_spacing, p.lines.line_window, p.lines.min_line_points,
                            p.extraction.min_plane_inliers, p.cleanup.min_region_pixels};
  };
  EXPECT_EQ(values_at(640), (std::vector<int>{12, 5, 4, 2100, 400}));
  EXPECT_EQ(values_at(320), (std::vector<int>{10, 4, 3, 525, 100}));
}

TEST(Resolve, HasWindowsOfAtMostHalfAGivenSpacingAndAtLeastThree) {
  Parameters given;
  for (const auto& [spacing, window] :
       {std::pair{1, 3}, {4, 3}, {5, 3}, {6, 3}, {8, 4}, {9, 4}, {10, 5}, {30, 5}}) {
    given.scanlines.scanline_spacing = spacing;
    EXPECT_EQ(resolve(given, 640).lines.line_window, window) << spacing;
  }
}

TEST(Resolve, HasLeastLengthsInTinyImages) {
  const Parameters p = adaptiveParameters(20);
  EXPECT_EQ(p.scanlines.scanline_spacing, 4);
  EXPECT_EQ(p.lines.line_window, 3);
  EXPECT_EQ(p.lines.min_line_points, 2);
  EXPECT_EQ(paperParameters(20).candidates.normal_window, 6);
}

}  // namespace
}  // namespace line_plane_segmentation
