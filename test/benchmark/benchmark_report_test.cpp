// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "report.h"
#include "table.h"
#include "time_picture.h"

namespace line_plane_segmentation {
namespace {

Measurement measured(const std::string& frame, int width, const std::string& method, double median) {
  return {frame, width, width * 3 / 4, method, 4, {median, median / 2, median * 2, 20}, {}};
}

std::vector<Measurement> twoSizes() {
  return {measured("hall", 640, "adaptive", 1.0), measured("hall", 640, "omps", 80.0),
          measured("hall", 320, "adaptive", 0.25), measured("hall", 320, "omps", 15.0)};
}

TEST(RatioToReference, IsTakenOnTheSameFrameAndSize) {
  const auto all = twoSizes();
  EXPECT_DOUBLE_EQ(ratioToReference(all, all[0]), 80.0);
  EXPECT_DOUBLE_EQ(ratioToReference(all, all[2]), 60.0);
  EXPECT_DOUBLE_EQ(ratioToReference(all, all[3]), 1.0);
  EXPECT_DOUBLE_EQ(ratioToReference({all[0]}, all[0]), 0.0) << "no reference";
}

TEST(TimesCsv, HasARowForEachMeasurement) {
  const std::string csv = timesCsv(twoSizes());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_NE(csv.find("hall,320,240,adaptive,0.250000,0.125000,0.500000,20,4,60.000000\n"), std::string::npos);
}

TEST(MarkdownReport, ComparesOnTheSameFrame) {
  BenchmarkResults results;
  results.frames = twoSizes();
  const std::string text = markdownReport(results);
  EXPECT_NE(text.find("| hall, 640x480 | adaptive | 1.00 | 0.500 | 2.00 | 20 | 4 | 80.0 |"),
            std::string::npos);
  EXPECT_NE(text.find("| hall, 320x240 | - | - | - |"), std::string::npos) << "methods left out";
  EXPECT_EQ(text.find("Cameras"), std::string::npos) << "what was not measured";
}

TEST(ThreeDigits, WhateverTheSize) {
  EXPECT_EQ(threeDigits(0.01234), "0.012");
  EXPECT_EQ(threeDigits(0.1234), "0.123");
  EXPECT_EQ(threeDigits(1.234), "1.23");
  EXPECT_EQ(threeDigits(12.34), "12.3");
  EXPECT_EQ(threeDigits(1234.4), "1234");
}

TEST(DrawTimes, ShowsTheFirstSizeAlone) {
  const auto all = twoSizes();
  const cv::Mat both = drawTimes(all);
  const cv::Mat first = drawTimes({all[0], all[1]});
  EXPECT_EQ(cv::norm(both, first), 0.0);
  EXPECT_GT(cv::norm(both, drawTimes({all[0], measured("hall", 640, "omps", 800.0)})), 0.0);
}

}  // namespace
}  // namespace line_plane_segmentation
