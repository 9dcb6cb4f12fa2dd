// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {
namespace {

/// The parameters that follow the image's width.
std::vector<int> automaticValues(const Parameters& p) {
  return {p.scanlines.scanline_spacing,   p.lines.line_window,
          p.lines.min_line_points,        p.candidates.normal_window,
          p.candidates.min_window_points, p.extraction.min_plane_inliers};
}

TEST(Resolve, GivesThePapersTable) {
  EXPECT_EQ(automaticValues(resolve({}, 640)), (std::vector<int>{30, 11, 30, 20, 240, 5000}));
  EXPECT_EQ(automaticValues(resolve({}, 320)), (std::vector<int>{20, 7, 23, 20, 240, 1000}));
  for (const int width : {320, 640}) {
    EXPECT_EQ(resolve({}, width).extraction.plane_distance, 0.02);
    EXPECT_EQ(resolve({}, width).extraction.neighbor_distance, 0.03);
  }
}

TEST(Resolve, NeverFallsAsTheWidthGrows) {
  std::vector<int> previous = automaticValues(resolve({}, 160));
  for (int width = 161; width <= 1920; ++width) {
    const std::vector<int> values = automaticValues(resolve({}, width));
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_GE(values[i], previous[i]) << width << ", parameter " << i;
    previous = values;
  }
}

TEST(Resolve, IsSensibleAtEveryWidth) {
  for (int width = 160; width <= 1920; ++width) {
    const Parameters p = resolve({}, width);
    const int spacing = p.scanlines.scanline_spacing, window = p.candidates.normal_window;
    EXPECT_GE(width / spacing, 15) << width;
    EXPECT_LE(width / spacing, 22) << width;
    EXPECT_EQ(p.lines.line_window % 2, 1) << width;
    EXPECT_GE(p.lines.line_window, 5) << width;
    EXPECT_GE(p.lines.min_line_points, p.lines.line_window + 2) << "three windows fit at " << width;
    EXPECT_LE(p.lines.min_line_points, width / 12) << width;
    EXPECT_GE(window, 10) << width;
    EXPECT_LE(p.candidates.min_window_points, window * window) << width;
    EXPECT_GE(p.candidates.min_window_points, window * window / 2) << width;
    const double share = p.extraction.min_plane_inliers / (0.75 * width * width);
    EXPECT_GT(share, 0.01) << width;
    EXPECT_LT(share, 0.02) << width;
  }
}

TEST(Resolve, LeavesWhatIsGiven) {
  Parameters given;
  given.scanlines.scanline_spacing = 3;
  given.lines.line_window = 5;
  given.lines.min_line_points = 7;
  given.candidates.normal_window = 9;
  given.candidates.min_window_points = 11;
  given.extraction.min_plane_inliers = 13;
  for (const int width : {160, 320, 640, 1920}) {
    EXPECT_EQ(automaticValues(resolve(given, width)), automaticValues(given)) << width;
  }
}

TEST(Resolve, TakesWindowPointsFromAGivenWindow) {
  Parameters given;
  given.candidates.normal_window = 10;
  EXPECT_EQ(resolve(given, 640).candidates.min_window_points, 60);
}

TEST(Resolve, DoneTwiceIsDoneOnce) {
  for (const int width : {160, 320, 500, 640, 1280, 1920}) {
    const Parameters once = resolve({}, width);
    EXPECT_EQ(automaticValues(resolve(once, width)), automaticValues(once)) << width;
  }
}

TEST(Resolve, LeavesNothingAutomaticEvenAtNoWidth) {
  for (const int width : {-5, 0, 1, 2, 20}) {
    for (const int value : automaticValues(resolve({}, width))) EXPECT_GE(value, 1) << width;
  }
}

TEST(Resolve, StaysWithinTheBounds) {
  for (const int width : {1, 160, 1920, 3840}) {
    Parameters p = resolve({}, width);
    EXPECT_TRUE(sanitize(p).empty()) << width;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
