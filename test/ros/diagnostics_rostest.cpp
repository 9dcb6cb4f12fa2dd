// SPDX-License-Identifier: BSD-3-Clause
// The status in /diagnostics, when input is missing and in normal operation.
#include <gtest/gtest.h>

#include <line_plane_segmentation/PlaneArray.h>

#include <algorithm>
#include <string>

#include "test_camera.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;

class Reports : public testing::Test {
 protected:
  const DiagnosticStatus& status() const { return diagnostics_.newest(); }

  bool says(const std::string& message) const {
    return waitUntil([&] { return status().message == message; });
  }

  double number(const std::string& key) const {
    const double number = diagnostics_.number(key);
    EXPECT_GE(number, 0.0) << "no " << key;
    return number;
  }

  TestCamera camera_;
  Diagnostics diagnostics_;
};

TEST_F(Reports, speakPlainly) {
  EXPECT_TRUE(says("nobody subscribes to my outputs: idle")) << status().message;
  EXPECT_EQ(DiagnosticStatus::OK, status().level);

  const Inbox<PlaneArray> planes("plane_segmenter/planes");
  EXPECT_TRUE(says("waiting for images on /depth/image_rect")) << status().message;

  sensor_msgs::Image image = imageOfPlane(320, 240, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5);
  const sensor_msgs::CameraInfo info = testInfo(320, 240);
  const std::string no_info = "waiting for camera_info on /depth/camera_info";
  EXPECT_TRUE(waitUntil([&] {
    camera_.publishImage(image, ros::Time::now());
    return status().message == no_info;
  })) << status().message;

  EXPECT_TRUE(waitUntil([&] {
    camera_.publish(image, info, ros::Time::now());
    spinFor(0.02);
    return status().message == "segmenting" && number("rate [Hz]") > 10.0;
  })) << status().message;
  EXPECT_EQ(DiagnosticStatus::OK, status().level);
  EXPECT_EQ(kCameraFrame, status().hardware_id);
  EXPECT_EQ(1.0, number("planes a frame"));
  EXPECT_EQ(100.0, number("pixels with depth [%]"));
  EXPECT_GT(number("delay [ms]"), 0.0);
  EXPECT_GE(number("longest delay [ms]"), number("delay [ms]"));
  EXPECT_LT(number("longest delay [ms]"), 1000.0);
  EXPECT_EQ(0.0, number("frames dropped"));
  double stages = 0.0;
  for (const char* stage : {"lines", "candidates", "extraction", "refinement", "outlines"}) {
    const double milliseconds = number(std::string("time of ") + stage + " [ms]");
    EXPECT_GE(milliseconds, 0.0);
    stages += milliseconds;
  }
  EXPECT_GT(stages, 0.0);
  EXPECT_NEAR(number("time a frame [ms]"), stages + number("time of outputs [ms]"), 0.05);

  image.encoding = "rgb8";
  EXPECT_TRUE(waitUntil([&] {
    camera_.publish(image, info, ros::Time::now());
    spinFor(0.02);
    return status().level == DiagnosticStatus::WARN;
  }));
  EXPECT_EQ(0U, status().message.find("refused (encoding): encoding 'rgb8' is no depth image"))
      << status().message;
  EXPECT_GT(number("frames refused: encoding"), 0.0);
}

// As by a program that requests again and again what is refused.
TEST(Log, isNotFilledByRefusedSettings) {
  const auto request = [](PlaneSegmenterConfig& config) { config.tf_fallback = "sometimes"; };
  const std::string refused = "tf_fallback = 'sometimes' was refused";
  const LogLines log;
  spinFor(5.1);
  const ros::WallTime begin = ros::WallTime::now();
  for (int i = 0; i < 50; ++i) reconfigure(request);
  // Ten lines in each span of five seconds, and a slow machine takes several for so many requests.
  const int spans = 1 + static_cast<int>((ros::WallTime::now() - begin).toSec() / 5.0);
  spinFor(0.5);
  const int printed = log.warnings(refused);
  EXPECT_GE(printed, 10);
  EXPECT_LE(printed, std::min(10 * spans, 49));
  spinFor(5.1);
  reconfigure(request);
  EXPECT_TRUE(waitUntil([&] { return log.warnings("more settings were refused or changed") >= 1; }));
  EXPECT_EQ(printed + 1, log.warnings(refused));
}

}  // namespace
}  // namespace line_plane_segmentation
