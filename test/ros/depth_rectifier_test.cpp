// SPDX-License-Identifier: BSD-3-Clause
#include "depth_rectifier.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <boost/make_shared.hpp>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>

#include "frame_segmenter.h"
#include "rectification_mode.h"
#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 256;
constexpr std::uint32_t kHeight = 256;

struct Lens {
  const char* name;
  const char* model;
  std::vector<double> distortion;
  double focal_length;
};

// A Kinect's, an Azure Kinect's wide view, a T265's.
const std::vector<Lens> kLenses = {
    {"plumb_bob", "plumb_bob", {0.26, -0.8, 0.001, -0.002, 0.9}, 225.0},
    {"barrel", "plumb_bob", {-0.28, 0.07, 0.0, 0.0, 0.0}, 150.0},
    {"rational", "rational_polynomial", {0.45, 0.05, 0.0, 0.0, 0.0013, 0.79, 0.135, 0.009}, 126.0},
    {"equidistant", "equidistant", {-0.008, 0.04, -0.038, 0.006}, 143.0}};

sensor_msgs::CameraInfo infoOf(const Lens& lens) {
  sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);
  const double f = lens.focal_length;
  const double c = 0.5 * (kWidth - 1) + 3.0;
  info.distortion_model = lens.model;
  info.D = lens.distortion;
  info.K = {f, 0.0, c, 0.0, f, c, 0.0, 0.0, 1.0};
  info.P = {f, 0.0, c, 0.0, 0.0, f, c, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

// The rays of all pixels, by OpenCV's own way back.
std::vector<cv::Point2d> raysOf(const Lens& lens) {
  const sensor_msgs::CameraInfo info = infoOf(lens);
  const cv::Matx33d k(info.K.data());
  std::vector<cv::Point2d> pixels, rays;
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) pixels.emplace_back(u, v);
  }
  if (std::string(lens.model) == "equidistant") {
    cv::fisheye::undistortPoints(pixels, rays, k, lens.distortion);
  } else {
    const cv::TermCriteria thorough(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-9);
    cv::undistortPoints(pixels, rays, k, lens.distortion, cv::noArray(), cv::noArray(), thorough);
  }
  return rays;
}

// A floor 1 m below the camera, which looks down by 30 degrees, and no farther than 8 m.
const Eigen::Vector3d kFloor(0.0, -std::cos(M_PI / 6), -std::sin(M_PI / 6));

sensor_msgs::Image rawFloor(const Lens& lens, const std::string& encoding) {
  sensor_msgs::Image image = testImage(kWidth, kHeight, encoding);
  const std::vector<cv::Point2d> rays = raysOf(lens);
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
    const double z = -1.0 / kFloor.dot(Eigen::Vector3d(rays[i].x, rays[i].y, 1.0));
    if (z > 0.0 && z < 8.0 && std::abs(rays[i].x) < 4.0) setDepth(image, i % kWidth, i / kWidth, z);
  }
  return image;
}

class DepthRectifierTest : public testing::TestWithParam<Lens> {};

TEST_P(DepthRectifierTest, givesWhatAPinholeCameraSees) {
  const sensor_msgs::CameraInfo info = infoOf(GetParam());
  const sensor_msgs::Image image = rawFloor(GetParam(), "32FC1");
  DepthRectifier rectifier;
  ASSERT_TRUE(rectifier.setCamera(info, kWidth, kHeight));
  const DepthView view = rectifier.rectify(validate(image, info).view);
  const CameraIntrinsics& camera = rectifier.camera();
  ASSERT_EQ(static_cast<int>(kWidth), view.width);

  std::vector<float> row(kWidth);
  int with_depth = 0;
  int outside = 0;
  for (int v = 0; v < view.height; ++v) {
    loadRow(view, v, {0.0F, 8.0F}, row.data());
    for (int u = 0; u < view.width; ++u) {
      const double z = -1.0 / kFloor.dot(rayOf(camera, u, v));
      const bool is_floor = z > 0.0 && z < 7.5;
      const float found = row[static_cast<std::size_t>(u)];
      if (is_floor && found == 0.0F) ++outside;
      if (!is_floor || found == 0.0F) continue;
      ++with_depth;
      EXPECT_NEAR(1.0, found / z, 0.01) << u << ", " << v;
    }
  }
  EXPECT_GT(with_depth, 10000);
  EXPECT_LT(outside, with_depth / 4) << "only corners of the rectified image are outside of the raw one";
}

TEST_P(DepthRectifierTest, seesAllThatTheRawImageHasOnItsAxes) {
  const sensor_msgs::CameraInfo info = infoOf(GetParam());
  DepthRectifier rectifier;
  ASSERT_TRUE(rectifier.setCamera(info, kWidth, kHeight));
  const CameraIntrinsics& camera = rectifier.camera();
  const std::vector<cv::Point2d> rays = raysOf(GetParam());
  const std::size_t middle = 131;
  EXPECT_NEAR(0.0, camera.cx + camera.fx * rays[middle * kWidth].x, 1.5);
  EXPECT_NEAR(kWidth - 1.0, camera.cx + camera.fx * rays[middle * kWidth + kWidth - 1].x, 1.5);
  EXPECT_NEAR(kHeight - 1.0, camera.cy + camera.fy * rays[(kHeight - 1) * kWidth + middle].y, 1.5);
}

// A wall at 1 m before one at 3 m, and a part without depth: no depth in between, and none from nothing.
TEST_P(DepthRectifierTest, keepsDepthSteps) {
  const sensor_msgs::CameraInfo info = infoOf(GetParam());
  sensor_msgs::Image image = testImage(kWidth, kHeight, "32FC1");
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) {
      if (v < 3 * kHeight / 4) setDepth(image, u, v, (u / 20 + v / 30) % 2 == 0 ? 1.0 : 3.0);
    }
  }
  DepthRectifier rectifier;
  ASSERT_TRUE(rectifier.setCamera(info, kWidth, kHeight));
  const DepthView view = rectifier.rectify(validate(image, info).view);
  std::vector<float> row(kWidth);
  std::map<int, int> pixels_with;  // this depth [mm]
  for (int v = 0; v < view.height; ++v) {
    loadRow(view, v, {0.0F, 8.0F}, row.data());
    for (const float z : row) ++pixels_with[static_cast<int>(std::lround(1000.0F * z))];
  }
  EXPECT_GT(pixels_with[0], 1000);
  EXPECT_GT(pixels_with[1000], 1000);
  EXPECT_GT(pixels_with[3000], 1000);
  EXPECT_EQ(pixels_with.size(), 3U) << "no other depth";
}

TEST_P(DepthRectifierTest, keepsTheFloorWhole) {
  InputFrame frame;
  frame.image = boost::make_shared<sensor_msgs::Image>(rawFloor(GetParam(), "16UC1"));
  frame.info = boost::make_shared<sensor_msgs::CameraInfo>(infoOf(GetParam()));
  frame.needs_rectification = true;
  FrameSegmenter segmenter;
  ASSERT_TRUE(segmenter.segment(frame).accepted());
  const Segmentation& segmentation = segmenter.segmentation();
  ASSERT_FALSE(segmentation.planes.empty());
  EXPECT_GT(segmentation.planes[0].inliers, 0.95 * segmentation.valid_pixels);
  EXPECT_GT(segmentation.planes[0].normal.dot(kFloor), std::cos(1.0 * M_PI / 180.0));
  EXPECT_NEAR(1.0, segmentation.planes[0].d, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Lenses, DepthRectifierTest, testing::ValuesIn(kLenses),
                         [](const auto& lens) { return lens.param.name; });

TEST(DepthRectifier, followsPWhereItDiffersFromK) {
  sensor_msgs::CameraInfo info = infoOf(kLenses[0]);
  info.P[0] = info.P[5] = 180.0;
  DepthRectifier rectifier;
  ASSERT_TRUE(rectifier.setCamera(info, kWidth, kHeight));
  EXPECT_EQ(180.0, rectifier.camera().fx);
  EXPECT_EQ(info.P[2], rectifier.camera().cx);
}

TEST(DepthRectifier, refusesWhatItDoesNotKnow) {
  DepthRectifier rectifier;
  sensor_msgs::CameraInfo info = infoOf(kLenses[0]);
  info.distortion_model = "Brown Conrady";
  EXPECT_FALSE(rectifier.setCamera(info, kWidth, kHeight));
  info = infoOf(kLenses[0]);
  info.D.resize(3);
  EXPECT_FALSE(rectifier.setCamera(info, kWidth, kHeight));
  info = infoOf(kLenses[0]);
  info.D[1] = std::nan("");
  EXPECT_FALSE(rectifier.setCamera(info, kWidth, kHeight));
  info = infoOf(kLenses[0]);
  info.K[0] = 0.0;
  EXPECT_FALSE(rectifier.setCamera(info, kWidth, kHeight));
  // Any numbers: no crash, no pixel from elsewhere.
  for (const double d : {1e30, -1e30, 50.0, -50.0}) {
    info = infoOf(kLenses[1]);
    info.D[0] = d;
    if (!rectifier.setCamera(info, kWidth, kHeight)) continue;
    rectifier.rectify(validate(testImage(kWidth, kHeight, "16UC1"), info).view);
  }
}

// image_rect has the same camera_info as image_raw, with the distortion that it no longer has.
TEST(FrameSegmenter, leavesRectifiedImagesAlone) {
  InputFrame frame;
  frame.image = boost::make_shared<sensor_msgs::Image>(rawFloor(kLenses[2], "16UC1"));
  frame.info = boost::make_shared<sensor_msgs::CameraInfo>(infoOf(kLenses[2]));
  FrameSegmenter segmenter;
  ASSERT_TRUE(segmenter.segment(frame).accepted());
  EXPECT_TRUE(segmenter.input().distorted);
  EXPECT_EQ(frame.image->data.data(), segmenter.input().view.data);
}

TEST(RectificationMode, goesByTheTopicIfNotTold) {
  EXPECT_TRUE(needsRectification(RectificationMode::kAuto, "/camera/depth/image_raw"));
  EXPECT_TRUE(needsRectification(RectificationMode::kAuto, "/rectified/depth/image"));
  EXPECT_FALSE(needsRectification(RectificationMode::kAuto, "/camera/depth/image_rect"));
  EXPECT_FALSE(needsRectification(RectificationMode::kAuto, "/camera/depth/image_rect_raw"))
      << "RealSense calls it so, and it is";
  EXPECT_TRUE(needsRectification(RectificationMode::kAlways, "/camera/depth/image_rect"));
  EXPECT_FALSE(needsRectification(RectificationMode::kNever, "/camera/depth/image_raw"));
}

}  // namespace
}  // namespace line_plane_segmentation
