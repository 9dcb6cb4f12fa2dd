// SPDX-License-Identifier: BSD-3-Clause
// Rows 27 and 35: two segmenters in one manager are independent, and one continues when the other is
// unloaded.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <string>

#include "nodelet_calls.h"
#include "reconfigure.h"
#include "test_camera.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

// A segmenter, its camera in front of a wall, and a subscriber of its planes.
struct Side {
  Side(const std::string& side_name, double wall_distance)
      : name("/" + side_name + "/plane_segmenter"),
        distance(wall_distance),
        camera(side_name),
        planes(name + "/planes"),
        diagnostics(side_name + "/plane_segmenter"),
        image(imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), wall_distance)) {}

  const std::string name;
  const double distance;  // [m]
  TestCamera camera;
  Inbox<PlaneArray> planes;
  Diagnostics diagnostics;
  const sensor_msgs::Image image;
};

class TwoCameras : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("/manager/load_nodelet", 15000));
    for (const Side* side : {&left_, &right_}) {
      ASSERT_TRUE(loadSegmenter(side->name));
      ASSERT_TRUE(side->camera.waitForSubscriber());
    }
  }

  void TearDown() override {
    for (const Side* side : {&left_, &right_}) {
      unloadSegmenter(side->name);
      // Reconfiguring leaves the parameter on the server for the next segmenter of that name.
      ros::param::del(side->name);
    }
  }

  void publish(Side& side) { side.camera.publish(side.image, info_, ros::Time(seconds_)); }

  void expectAnswer(Side& side, std::size_t planes) {
    ASSERT_TRUE(side.planes.waitFor(ros::Time(seconds_)));
    ASSERT_EQ(planes, side.planes.newest()->planes.size());
    if (planes == 0) return;
    EXPECT_NEAR(side.distance, side.planes.newest()->planes[0].coefficients.coef[3], 0.005);
  }

  // Both receive images with one timestamp and publish this number of planes.
  void publishAndExpect(std::size_t left, std::size_t right) {
    seconds_ += 0.1;
    publish(left_);
    publish(right_);
    expectAnswer(left_, left);
    expectAnswer(right_, right);
  }

  Side left_{"left", 1.0};
  Side right_{"right", 2.0};
  const sensor_msgs::CameraInfo info_ = testInfo(kWidth, kHeight);
  double seconds_ = 1000.0;
};

TEST_F(TwoCameras, areIndependent) {
  for (int i = 0; i < 30; ++i) publishAndExpect(1, 1);

  dynamic_reconfigure::Reconfigure call;
  setDouble(call, "max_range", 0.8);
  reconfigure(call, left_.name);
  for (int i = 0; i < 3; ++i) publishAndExpect(0, 1);

  left_.camera.publish(left_.image, sensor_msgs::CameraInfo(), ros::Time(seconds_ += 0.1));
  EXPECT_TRUE(left_.diagnostics.waitForValue("frames refused: info_mismatch", "1"));
  EXPECT_TRUE(right_.diagnostics.waitForReport());
  EXPECT_EQ("0", right_.diagnostics.value("frames refused: info_mismatch"));
}

TEST_F(TwoCameras, oneGoesOnWhenTheOtherLeaves) {
  publishAndExpect(1, 1);
  for (int round = 0; round < 5; ++round) {
    const int answers = right_.planes.count();
    for (int i = 0; i < 5; ++i) {
      seconds_ += 0.1;
      publish(left_);
      publish(right_);
    }
    ASSERT_TRUE(unloadSegmenter(left_.name));
    EXPECT_TRUE(waitUntil([&] { return right_.planes.count() == answers + 5; })) << right_.planes.count();
    ASSERT_TRUE(loadSegmenter(left_.name));
    ASSERT_TRUE(left_.camera.waitForSubscriber());
    publishAndExpect(1, 1);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
