// SPDX-License-Identifier: BSD-3-Clause
// Row 20: images arrive without camera_info, or without one of the same timestamp. After ten seconds the
// diagnostics warn and name the topic; with a camera_info, normal operation starts.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <string>

#include "test_camera.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;

// A segmenter and its camera in a namespace of their own.
struct Side {
  explicit Side(const std::string& name)
      : camera(name), planes(name + "/plane_segmenter/planes"), diagnostics(name + "/plane_segmenter") {}

  TestCamera camera;
  Inbox<PlaneArray> planes;
  Diagnostics diagnostics;
};

class Silence : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(without_info_.camera.waitForSubscriber());
    ASSERT_TRUE(other_stamps_.camera.waitForSubscriber());
  }

  void publishWhatDoesNotFit() {
    seconds_ += 0.1;
    without_info_.camera.publishImage(image_, ros::Time(seconds_));
    other_stamps_.camera.publishImage(image_, ros::Time(seconds_));
    other_stamps_.camera.publishInfo(info_, ros::Time(seconds_ + 0.01));
  }

  // Publishes for this time, or until both warn.
  bool warnWithin(double seconds) {
    const auto warns = [](const Side& side) {
      return side.diagnostics.newest().level == DiagnosticStatus::WARN;
    };
    return waitUntil(
        [&] {
          publishWhatDoesNotFit();
          spinFor(0.05);
          return warns(without_info_) && warns(other_stamps_);
        },
        seconds);
  }

  static void expectMessage(const Side& side, const std::string& text) {
    EXPECT_NE(std::string::npos, side.diagnostics.newest().message.find(text))
        << side.diagnostics.newest().message;
  }

  void expectThatAllIsWell(Side& side) {
    const ros::Time stamp(seconds_ += 0.1);
    side.camera.publish(image_, info_, stamp);
    EXPECT_TRUE(side.planes.waitFor(stamp));
    EXPECT_EQ(1U, side.planes.newest()->planes.size());
    EXPECT_TRUE(side.diagnostics.waitForStatus(DiagnosticStatus::OK, "segmenting"));
  }

  Side without_info_{"without_info"};
  Side other_stamps_{"other_stamps"};
  sensor_msgs::Image image_ = imageOfPlane(320, 240, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5);
  sensor_msgs::CameraInfo info_ = testInfo(320, 240);
  double seconds_ = 1000.0;
};

TEST_F(Silence, isExplained) {
  EXPECT_FALSE(warnWithin(7.0)) << "too early: a camera may take some time to start";
  EXPECT_TRUE(warnWithin(10.0));
  expectMessage(without_info_, "waiting for camera_info on /without_info/depth/camera_info");
  expectMessage(other_stamps_,
                "camera_info on /other_stamps/depth/camera_info with the stamp of an image on "
                "/other_stamps/depth/image_rect");
  EXPECT_EQ(0, without_info_.planes.count());
  EXPECT_EQ(0, other_stamps_.planes.count());
  expectThatAllIsWell(without_info_);
  expectThatAllIsWell(other_stamps_);
}

}  // namespace
}  // namespace line_plane_segmentation
