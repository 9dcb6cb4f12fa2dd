// SPDX-License-Identifier: BSD-3-Clause
#include "frame_variant.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include "region_overlap.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 7, kHeight = 5;

// The pixel (5, 1) is marked in depth and ground truth. Its ray is (1, -0.5).
LabelledFrame markedFrame() {
  LabelledFrame frame;
  frame.name = "a";
  frame.depth = cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(1000));
  frame.truth = cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(1));
  frame.depth.at<std::uint16_t>(1, 5) = 2000;
  frame.truth.at<std::uint16_t>(1, 5) = 2;
  frame.camera = {2.0, 4.0, 3.0, 3.0};
  return frame;
}

// The ray through the pixel marked in depth, which must be marked in the ground truth, too.
cv::Point2d markedRay(const LabelledFrame& frame) {
  cv::Point at;
  cv::minMaxLoc(frame.depth, nullptr, nullptr, nullptr, &at);
  EXPECT_EQ(frame.truth.at<std::uint16_t>(at), 2);
  return {(at.x - frame.camera.cx) / frame.camera.fx, (at.y - frame.camera.cy) / frame.camera.fy};
}

TEST(FrameVariant, TurnsIntrinsicsWithTheImage) {
  const std::map<Orientation, cv::Point2d> rays = {{Orientation::kUpright, {1.0, -0.5}},
                                                   {Orientation::kMirrored, {-1.0, -0.5}},
                                                   {Orientation::kQuarterTurn, {0.5, 1.0}},
                                                   {Orientation::kHalfTurn, {-1.0, 0.5}}};
  for (const auto& [orientation, ray] : rays) {
    const LabelledFrame frame = turned(markedFrame(), orientation);
    const bool is_quarter = orientation == Orientation::kQuarterTurn;
    EXPECT_EQ(frame.depth.size(), is_quarter ? cv::Size(kHeight, kWidth) : cv::Size(kWidth, kHeight));
    EXPECT_EQ(frame.truth.size(), frame.depth.size());
    EXPECT_EQ(markedRay(frame), ray);
  }
}

TEST(FrameVariant, ShiftKeepsRaysAndJudgedPixels) {
  const LabelledFrame frame = shifted(markedFrame(), 3);
  EXPECT_EQ(frame.depth.size(), cv::Size(kWidth + 3, kHeight + 3));
  EXPECT_EQ(markedRay(frame), cv::Point2d(1.0, -0.5));
  EXPECT_EQ(cv::countNonZero(frame.depth), kWidth * kHeight);
  EXPECT_EQ(cv::countNonZero(frame.truth != kDoNotJudge), kWidth * kHeight);
}

TEST(FrameVariant, AllVariantsDiffer) {
  std::set<std::tuple<int, double, bool>> different;
  for (const FrameVariant& v : allVariants()) {
    different.insert({static_cast<int>(v.orientation), v.spacing_factor, v.is_shifted});
  }
  EXPECT_EQ(different.size(), 40U);
  EXPECT_EQ(allVariants().size(), 40U);
  EXPECT_EQ(different.begin(), different.find({0, 10.0 / 12.0, false}));
  EXPECT_EQ(std::get<1>(*different.rbegin()), 14.0 / 12.0);
}

TEST(FrameVariant, FewVariantsHoldEachOrientationAndBothPhases) {
  std::map<Orientation, std::set<bool>> phases;
  for (const FrameVariant& v : fewVariants()) phases[v.orientation].insert(v.is_shifted);
  EXPECT_EQ(phases.size(), 4U);
  for (const auto& [orientation, both] : phases) EXPECT_EQ(both.size(), 2U);
}

}  // namespace
}  // namespace line_plane_segmentation
