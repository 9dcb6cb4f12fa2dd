// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "depth_frames.h"
#include "overlay.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;
const CameraIntrinsics kCamera{60.0, 60.0, 31.5, 23.5};

bool isGrey(const cv::Vec3b& pixel) { return pixel[0] == pixel[1] && pixel[1] == pixel[2]; }

Segmentation blankSegmentation() {
  Segmentation segmentation;
  segmentation.width = kWidth;
  segmentation.height = kHeight;
  segmentation.labels.assign(static_cast<std::size_t>(kWidth) * kHeight, 0);
  return segmentation;
}

TEST(Overlay, IsGreyWithoutPlanesLightWhereNearAndDarkestWithoutDepth) {
  cv::Mat depth(kHeight, kWidth, CV_16UC1, cv::Scalar(1000));
  depth.colRange(20, 40).setTo(3000);
  depth.colRange(40, kWidth).setTo(0);
  const cv::Mat picture = drawOverlay(depthViewOf(depth, 0.001), blankSegmentation(), kCamera);
  ASSERT_EQ(picture.type(), CV_8UC3);
  ASSERT_EQ(picture.size(), depth.size());
  for (auto it = picture.begin<cv::Vec3b>(); it != picture.end<cv::Vec3b>(); ++it) ASSERT_TRUE(isGrey(*it));
  EXPECT_GT(picture.at<cv::Vec3b>(10, 10)[0], picture.at<cv::Vec3b>(10, 30)[0]);
  EXPECT_GT(picture.at<cv::Vec3b>(10, 30)[0], picture.at<cv::Vec3b>(10, 50)[0]);
}

TEST(Overlay, TintsEachPlaneInItsColor) {
  const cv::Mat depth(kHeight, kWidth, CV_16UC1, cv::Scalar(1000));
  Segmentation segmentation = blankSegmentation();
  segmentation.labels[5 * kWidth + 3] = 1;
  segmentation.labels[5 * kWidth + 6] = 2;
  segmentation.labels[5 * kWidth + 9] = 65535;
  const cv::Mat picture = drawOverlay(depthViewOf(depth, 0.001), segmentation, kCamera);
  const auto& first = picture.at<cv::Vec3b>(5, 3);
  const auto& second = picture.at<cv::Vec3b>(5, 6);
  EXPECT_FALSE(isGrey(first));
  EXPECT_FALSE(isGrey(second));
  EXPECT_FALSE(isGrey(picture.at<cv::Vec3b>(5, 9)));
  EXPECT_NE(first, second);
  EXPECT_TRUE(isGrey(picture.at<cv::Vec3b>(5, 12)));
}

TEST(Overlay, DrawsOutlinesWhereTheyAreSeenAndSurvivesOnesThatAreNot) {
  const cv::Mat depth(kHeight, kWidth, CV_16UC1, cv::Scalar(1000));
  Segmentation segmentation = blankSegmentation();
  SegmentedPlane plane;
  plane.label = 1;
  plane.normal = {0.0, 0.0, -1.0};
  plane.d = 1.0;
  plane.centroid = {0.0, 0.0, 1.0};
  plane.outer_ring_count = 2;
  segmentation.planes.push_back(plane);
  segmentation.vertices = {{-0.4F, -0.3F, 1.F}, {0.4F, -0.3F, 1.F}, {0.4F, 0.3F, 1.F}, {-0.4F, 0.3F, 1.F},
                           {1e9F, 0.F, 1.F},    {0.F, 0.F, 0.F},    {0.F, -1e9F, -1.F}};
  segmentation.rings = {{0, 4}, {4, 3}};
  const cv::Mat picture = drawOverlay(depthViewOf(depth, 0.001), segmentation, kCamera);
  const int column = cvRound(60.0 * -0.4 + 31.5);
  EXPECT_FALSE(isGrey(picture.at<cv::Vec3b>(20, column)));
  EXPECT_TRUE(isGrey(picture.at<cv::Vec3b>(20, 2)));
}

TEST(Overlay, AcceptsAnImageWithoutDepth) {
  const cv::Mat depth = cv::Mat::zeros(kHeight, kWidth, CV_16UC1);
  EXPECT_EQ(cv::countNonZero(drawOverlay(depthViewOf(depth, 0.001), blankSegmentation(), kCamera).reshape(1)),
            0);
}

}  // namespace
}  // namespace line_plane_segmentation
