// SPDX-License-Identifier: BSD-3-Clause
// A fault of a frame is reported, counted, and does not affect later frames: each test ends with a valid
// frame whose plane is published. Row numbers are those of doc/reliability.md.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "test_camera.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using sensor_msgs::CameraInfo;
using sensor_msgs::Image;

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

const Eigen::Vector3d kNormal = Eigen::Vector3d(0.2, -0.4, -1.0).normalized();
constexpr double kDistance = 1.4;

class Faults : public testing::Test {
 protected:
  Faults() { EXPECT_TRUE(camera_.waitForSubscriber()); }

  // Returns a new timestamp for each frame.
  static ros::Time nextStamp() {
    static double seconds = 1000.0;
    return ros::Time(seconds += 0.1);
  }

  // The newest message has this timestamp and contains the plane.
  void expectThePlane(const ros::Time& stamp) const {
    ASSERT_TRUE(planes_.waitFor(stamp)) << "no planes at " << stamp;
    ASSERT_EQ(1U, planes_.newest()->planes.size());
    const auto& coef = planes_.newest()->planes[0].coefficients.coef;
    EXPECT_GT(Eigen::Vector3d(coef[0], coef[1], coef[2]).dot(kNormal), std::cos(0.5 * M_PI / 180.0));
    EXPECT_NEAR(kDistance, coef[3], 0.005);
  }

  void publishAndExpectThePlane(const Image& image, const CameraInfo& info) {
    const ros::Time stamp = nextStamp();
    camera_.publish(image, info, stamp);
    expectThePlane(stamp);
  }

  void expectThatGoodFramesWork() { publishAndExpectThePlane(good_, info_); }

  TestCamera camera_;
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  Diagnostics diagnostics_;
  LogLines log_;
  const Image good_ = imageOfPlane(kWidth, kHeight, "16UC1", kNormal, kDistance);
  const CameraInfo info_ = testInfo(kWidth, kHeight);
};

struct BadFrame {
  const char* reason;
  const char* advice;
  std::function<void(Image&, CameraInfo&)> spoil;
};

// Rows 1, 2, 3, 4, 6, 15, 17, 18.
const std::vector<BadFrame>& badFrames() {
  static const std::vector<BadFrame> kBadFrames = {
      {"empty_image", "check the camera driver", [](Image& i, CameraInfo&) { i.width = 0; }},
      {"short_data", "its header says", [](Image& i, CameraInfo&) { i.data.clear(); }},
      {"bad_step", "check the camera driver", [](Image& i, CameraInfo&) { i.step = 7; }},
      {"too_large", "~max_pixels", [](Image& i, CameraInfo&) { i.height = 0xFFFFFFFFU; }},
      {"encoding", "'rgb8'", [](Image& i, CameraInfo&) { i.encoding = "rgb8"; }},
      {"info_mismatch", "camera_info of this image's size", [](Image&, CameraInfo& c) { c.width = 640; }},
      {"no_intrinsics", "calibrate",
       [](Image&, CameraInfo& c) { c.K[0] = c.P[0] = std::numeric_limits<double>::quiet_NaN(); }},
  };
  return kBadFrames;
}

TEST_F(Faults, refusesBadFramesAndGoesOn) {
  constexpr int kTimes = 3;
  for (const BadFrame& bad : badFrames()) {
    SCOPED_TRACE(bad.reason);
    for (int i = 0; i < kTimes; ++i) {
      Image image = good_;
      CameraInfo info = info_;
      bad.spoil(image, info);
      const int answers = planes_.count();
      camera_.publish(image, info, nextStamp());
      expectThatGoodFramesWork();
      EXPECT_EQ(answers + 1, planes_.count());
    }
  }
  EXPECT_TRUE(diagnostics_.waitForReport());
  for (const BadFrame& bad : badFrames()) {
    EXPECT_EQ(std::to_string(kTimes), diagnostics_.value(std::string("frames refused: ") + bad.reason));
    EXPECT_EQ(1, log_.warnings(std::string("(") + bad.reason + ")")) << bad.reason << " is not throttled";
    EXPECT_LE(1, log_.warnings(bad.advice)) << bad.reason;
  }
}

// Row 15.
TEST_F(Faults, saysWhatToDoWithoutCalibration) {
  CameraInfo info = info_;
  info.K.fill(0.0);
  info.P.fill(0.0);
  camera_.publish(good_, info, nextStamp());
  EXPECT_TRUE(diagnostics_.waitForStatus(DiagnosticStatus::ERROR, "calibrate the camera"));
  expectThatGoodFramesWork();
  EXPECT_TRUE(diagnostics_.waitForStatus(DiagnosticStatus::OK, "segmenting"));
}

// Row 10.
TEST_F(Faults, saysWhenThereIsNoDepth) {
  const Image blind = testImage(kWidth, kHeight, "16UC1");
  EXPECT_TRUE(waitUntil([&] {
    const ros::Time stamp = nextStamp();
    camera_.publish(blind, info_, stamp);
    EXPECT_TRUE(planes_.waitFor(stamp));
    EXPECT_TRUE(planes_.newest()->planes.empty());
    EXPECT_EQ(0U, planes_.newest()->valid_pixels);
    return diagnostics_.newest().level == DiagnosticStatus::WARN &&
           diagnostics_.newest().message.find("no pixel has a depth") != std::string::npos;
  }));
  expectThatGoodFramesWork();
}

// Rows 5, 7, 8: all show the plane.
TEST_F(Faults, takesUnusualImages) {
  Image padded = testImage(kWidth, kHeight, "16UC1");
  padded.step += 3;  // the second row begins between two pixels
  padded.data.resize(std::size_t{padded.step} * kHeight);
  Image big_endian = good_;
  big_endian.is_bigendian = 1;
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    const auto row = good_.data.begin() + v * std::ptrdiff_t{good_.step};
    std::copy(row, row + good_.step, padded.data.begin() + v * std::ptrdiff_t{padded.step});
  }
  for (std::size_t i = 0; i < big_endian.data.size(); i += 2) {
    std::swap(big_endian.data[i], big_endian.data[i + 1]);
  }
  Image longer = good_;
  longer.data.resize(longer.data.size() + 1001);
  for (const Image& image :
       {padded, big_endian, longer, imageOfPlane(kWidth, kHeight, "mono16", kNormal, kDistance),
        imageOfPlane(kWidth, kHeight, "32FC1", kNormal, kDistance)}) {
    publishAndExpectThePlane(image, info_);
  }
  expectThatGoodFramesWork();
}

// Row 9.
TEST_F(Faults, passesOverWhatIsNoDepth) {
  Image image = imageOfPlane(kWidth, kHeight, "32FC1", kNormal, kDistance);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::uint32_t u = 0;
  for (const double z : {std::nan(""), kInfinity, -kInfinity, 0.0, -0.0, -1.5, 1e-40, 1e30}) {
    for (std::uint32_t v = 0; v < kHeight; ++v) setDepth(image, u, v, z);
    u += 7;
  }
  publishAndExpectThePlane(image, info_);
  expectThatGoodFramesWork();
}

// Row 11.
TEST_F(Faults, asksOnceIfMetresAreMillimetres) {
  const Image image = imageOfPlane(kWidth, kHeight, "32FC1", kNormal, 1000.0 * kDistance);
  for (int i = 0; i < 3; ++i) {
    const ros::Time stamp = nextStamp();
    camera_.publish(image, info_, stamp);
    ASSERT_TRUE(planes_.waitFor(stamp));
    EXPECT_TRUE(planes_.newest()->planes.empty());
  }
  expectThatGoodFramesWork();
  EXPECT_EQ(1, log_.warnings("are they in millimetres?"));
}

// Row 12.
TEST_F(Faults, findsLittleInNoise) {
  Image image = testImage(kWidth, kHeight, "16UC1");
  std::mt19937 random(1);
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u)
      setDepth(image, u, v, 1.0 + 1e-3 * static_cast<double>(random() % 2000));
  }
  const ros::Time stamp = nextStamp();
  camera_.publish(image, info_, stamp);
  ASSERT_TRUE(planes_.waitFor(stamp));
  EXPECT_LE(planes_.newest()->planes.size(), 1U);
  expectThatGoodFramesWork();
}

// Rows 13, 14.
TEST_F(Faults, takesOtherSizesInTheMidstOfTheStream) {
  for (const auto& [width, height] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
           {640, 480}, {320, 240}, {641, 479}, {3840, 2160}, {160, 120}, {640, 480}}) {
    SCOPED_TRACE(width);
    publishAndExpectThePlane(imageOfPlane(width, height, "16UC1", kNormal, kDistance),
                             testInfo(width, height));
  }
  for (const auto& [width, height] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 1}, {1, 480}, {640, 1}, {2, 2}}) {
    const ros::Time stamp = nextStamp();
    camera_.publish(imageOfPlane(width, height, "16UC1", kNormal, kDistance), testInfo(width, height), stamp);
    ASSERT_TRUE(planes_.waitFor(stamp));
    EXPECT_TRUE(planes_.newest()->planes.empty());
  }
  expectThatGoodFramesWork();
}

// Row 19.
TEST_F(Faults, saysOnceThatImagesAreNotRectified) {
  CameraInfo info = info_;
  info.D[0] = 0.1;
  for (int i = 0; i < 3; ++i) publishAndExpectThePlane(good_, info);
  expectThatGoodFramesWork();
  EXPECT_EQ(1, log_.warnings("has distortion"));
}

// Row 16.
TEST_F(Faults, takesKWherePIsMissing) {
  CameraInfo info = info_;
  info.P.fill(0.0);
  for (int i = 0; i < 3; ++i) publishAndExpectThePlane(good_, info);
  expectThatGoodFramesWork();
  EXPECT_EQ(1, log_.warnings("has no P"));
}

// Row 18: the sensor has 640x480 pixels; the image shows the 320x240 of it from (100, 60) on, two in one.
TEST_F(Faults, honoursBinningAndRegionOfInterest) {
  const CameraIntrinsics full = testCamera(640, 480);
  CameraInfo info = testInfo(640, 480);
  info.binning_x = info.binning_y = 2;
  info.roi.x_offset = 100;
  info.roi.y_offset = 60;
  info.roi.width = 320;
  info.roi.height = 240;
  Image image = testImage(160, 120, "16UC1");
  for (std::uint32_t v = 0; v < 120; ++v) {
    for (std::uint32_t u = 0; u < 160; ++u) {
      const Eigen::Vector3d ray((100.0 + 2.0 * u - full.cx) / full.fx, (60.0 + 2.0 * v - full.cy) / full.fy,
                                1.0);
      setDepth(image, u, v, -kDistance / kNormal.dot(ray));
    }
  }
  publishAndExpectThePlane(image, info);
  expectThatGoodFramesWork();
}

// Row 23: a camera without a clock, one whose clock is wrong, a bag that loops.
TEST_F(Faults, takesAnyStamp) {
  for (const double seconds : {9000.0, 9000.1, 1.0, 1.1, 0.0, 4294967295.0, 2.0}) {
    const int answers = planes_.count();
    camera_.publish(good_, info_, ros::Time(seconds));
    expectThePlane(ros::Time(seconds));
    EXPECT_EQ(answers + 1, planes_.count());
  }
}

// Row 25.
TEST_F(Faults, takesAnyFrameId) {
  Image image = good_;
  for (int i = 0; i < 2; ++i) {
    image.header.frame_id = std::string("/") + kCameraFrame;
    publishAndExpectThePlane(image, info_);
    EXPECT_EQ(kCameraFrame, planes_.newest()->header.frame_id);
    image.header.frame_id.clear();
    publishAndExpectThePlane(image, info_);
    EXPECT_EQ("", planes_.newest()->header.frame_id);
  }
  expectThatGoodFramesWork();
  EXPECT_EQ(1, log_.warnings("starts with a slash"));
  EXPECT_EQ(1, log_.warnings("no frame_id"));
}

}  // namespace
}  // namespace line_plane_segmentation
