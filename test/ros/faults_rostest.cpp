// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a frame is said, counted and over with it: each test ends with a good frame that is
// answered with its plane. The rows are those of doc/reliability.md.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
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

  // Every frame of the tests has its own stamp.
  static ros::Time nextStamp() {
    static double seconds = 1000.0;
    return ros::Time(seconds += 0.1);
  }

  // The newest answer is that to this stamp, and tells of the plane.
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

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "faults_rostest");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
