// SPDX-License-Identifier: BSD-3-Clause
// Simulated time is absent, stands still, jumps back as when a bag loops, or jumps an hour ahead: faults
// rows 21 and 22.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "reconfigure.h"
#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

class Clock : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(camera_.waitForSubscriber());
    reconfigure([](PlaneSegmenterConfig& config) {
      config.target_frame = config.gravity_frame = config.fixed_frame = "world";
    });
    ASSERT_TRUE(waitUntil([this] { return transforms_.getNumSubscribers() == 1; }));
  }

  // Publishes the wall's image, its transform and, if simulated time is used, the clock, all at this time.
  void publish(double seconds, bool with_clock) {
    rosgraph_msgs::Clock clock;
    clock.clock = ros::Time(seconds);
    if (with_clock) clock_.publish(clock);
    geometry_msgs::TransformStamped pose;
    pose.header.stamp = ros::Time(seconds);
    pose.header.frame_id = "world";
    pose.child_frame_id = kCameraFrame;
    pose.transform.rotation.w = 1.0;
    tf2_msgs::TFMessage message;
    message.transforms.push_back(pose);
    transforms_.publish(message);
    camera_.publish(image_, info_, ros::Time(seconds));
  }

  // Publishes ten images per second from this time on.
  // @return number of images that were answered, in the world frame
  int play(double first, int images, bool with_clock) {
    int answered = 0;
    for (int i = 0; i < images; ++i) {
      const double seconds = first + 0.1 * i;
      publish(seconds, with_clock);
      if (!planes_.waitFor(ros::Time(seconds), 0.5)) continue;
      EXPECT_EQ("world", planes_.newest()->header.frame_id);
      EXPECT_EQ(1U, planes_.newest()->planes.size());
      ++answered;
    }
    return answered;
  }

  ros::NodeHandle nh_;
  ros::Publisher clock_ = nh_.advertise<rosgraph_msgs::Clock>("/clock", 10);
  ros::Publisher transforms_ = nh_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  TestCamera camera_;
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  sensor_msgs::Image image_ = imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5);
  sensor_msgs::CameraInfo info_ = testInfo(kWidth, kHeight);
};

TEST_F(Clock, mayDoAnything) {
  EXPECT_GE(play(100.0, 5, false), 4) << "no clock at all";
  EXPECT_GE(play(200.0, 5, true), 4) << "a clock begins";
  EXPECT_EQ(5, play(201.0, 5, false)) << "it stands still";
  for (int loop = 0; loop < 2; ++loop) {
    EXPECT_GE(play(150.0, 5, true), 4) << "it goes back, loop " << loop;
    EXPECT_EQ(5, play(150.5, 5, true));
    EXPECT_EQ(1U, planes_.newest()->planes.at(0).id);
  }
  EXPECT_GE(play(3750.0, 5, true), 4) << "an hour is left out";
  EXPECT_EQ(5, play(3750.5, 5, true));
}

}  // namespace
}  // namespace line_plane_segmentation
