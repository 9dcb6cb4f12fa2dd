// SPDX-License-Identifier: BSD-3-Clause
// Planes in a target frame, their orientation, and missing transforms: faults rows 21, 24, 26.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "reconfigure.h"
#include "test_camera.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;
constexpr double kTilt = 40.0 * M_PI / 180.0;  // [rad] downward pitch of the camera

// A floor seen from 1.2 m above.
const Eigen::Vector3d kFloorNormal(0.0, -std::cos(kTilt), -std::sin(kTilt));
constexpr double kHeightAboveFloor = 1.2;

Eigen::Isometry3d cameraInWorld() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const double c = std::cos(kTilt), s = std::sin(kTilt);
  pose.linear() << 0, -s, c, -1, 0, 0, 0, -c, -s;
  pose.translation() << 5.0, -3.0, kHeightAboveFloor;
  return pose;
}

class Frames : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(camera_.waitForSubscriber()); }

  // Returns a new timestamp for each frame.
  static ros::Time nextStamp() {
    static double seconds = 1000.0;
    return ros::Time(seconds += 0.1);
  }

  // Publishes one transform.
  void sendTransform(const std::string& parent, const ros::Time& stamp) {
    geometry_msgs::TransformStamped message = tf2::eigenToTransform(cameraInWorld());
    message.header.stamp = stamp;
    message.header.frame_id = parent;
    message.child_frame_id = kCameraFrame;
    broadcaster_.sendTransform(message);
  }

  // "still" never moves; its transform is latched.
  void sendStaticTransform(const std::string& parent = "still", const std::string& child = "world",
                           const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity()) {
    geometry_msgs::TransformStamped message = tf2::eigenToTransform(pose);
    message.header.frame_id = parent;
    message.child_frame_id = child;
    static_broadcaster_.sendTransform(message);
  }

  void publish(const ros::Time& stamp) { camera_.publish(image_, info_, stamp); }

  /// Publishes until the segmenter, whose subscription of tf is new, has received it.
  bool answersSoon(const std::string& parent) {
    return waitUntil([&] {
      const ros::Time stamp = nextStamp();
      sendTransform(parent, stamp);
      publish(stamp);
      return planes_->waitFor(stamp, 0.3) && isOriented();
    });
  }

  bool isOriented() const {
    return !planes_->newest()->planes.empty() && planes_->newest()->planes[0].orientation != Plane::UNKNOWN;
  }

  /// Value from the newest report.
  int refusedForTf() const { return static_cast<int>(diagnostics_.number("frames refused: tf")); }

  /// Value from the next report, while no image arrives.
  int refusedUntilNow() const {
    EXPECT_TRUE(diagnostics_.waitForReport());
    return refusedForTf();
  }

  /// For tests about the time before anything subscribes to the planes.
  void unsubscribe() {
    planes_.reset();
    ASSERT_TRUE(camera_.waitForIdle());
  }
  void subscribe() {
    planes_.emplace("plane_segmenter/planes");
    ASSERT_TRUE(camera_.waitForSubscriber());
  }

  TestCamera camera_;
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  std::optional<Inbox<PlaneArray>> planes_{"plane_segmenter/planes"};
  Diagnostics diagnostics_;
  sensor_msgs::Image image_ = imageOfPlane(kWidth, kHeight, "16UC1", kFloorNormal, kHeightAboveFloor);
  sensor_msgs::CameraInfo info_ = testInfo(kWidth, kHeight);
};

TEST_F(Frames, givesAFloorInTheWorld) {
  const Inbox<sensor_msgs::PointCloud2> cloud("plane_segmenter/cloud");
  reconfigure([](PlaneSegmenterConfig& config) { config.target_frame = config.gravity_frame = "world"; });
  ASSERT_TRUE(answersSoon("world"));
  EXPECT_EQ("world", planes_->newest()->header.frame_id);
  const Plane& floor = planes_->newest()->planes.at(0);
  EXPECT_GT(floor.coefficients.coef[2], std::cos(0.5 * M_PI / 180.0));
  EXPECT_NEAR(0.0, floor.centroid.z, 0.01);
  EXPECT_GT(floor.centroid.x, 5.0) << "ahead of the camera";
  EXPECT_EQ(Plane::HORIZONTAL_UP, floor.orientation);
  for (const auto& point : floor.outline.points) EXPECT_NEAR(0.0, point.z, 0.02);
  ASSERT_TRUE(waitUntil([&] { return cloud.newest() != nullptr; }));
  EXPECT_EQ("world", cloud.newest()->header.frame_id);
}

TEST_F(Frames, leavesOutWhatIsNotWanted) {
  const auto only_walls = [](PlaneSegmenterConfig& config) {
    config.gravity_frame = "world";
    config.publish_horizontal_up = false;
  };
  reconfigure([](PlaneSegmenterConfig& config) { config.gravity_frame = "world"; });
  ASSERT_TRUE(answersSoon("world"));
  EXPECT_EQ(kCameraFrame, planes_->newest()->header.frame_id);
  reconfigure(only_walls);
  const ros::Time stamp = nextStamp();
  sendTransform("world", stamp);
  publish(stamp);
  ASSERT_TRUE(planes_->waitFor(stamp));
  EXPECT_TRUE(planes_->newest()->planes.empty());
  EXPECT_GT(planes_->newest()->valid_pixels, 0U);
}

TEST_F(Frames, refusesWhatItCannotPlaceAndNeverBlocks) {
  reconfigure([](PlaneSegmenterConfig& config) { config.target_frame = "nowhere"; });
  const int refused = refusedUntilNow();
  const int answers = planes_->count();
  for (int i = 0; i < 20; ++i) {
    publish(nextStamp());
    spinFor(1.0 / 30.0);
  }
  EXPECT_TRUE(waitUntil([&] { return refusedForTf() == refused + 20; })) << refusedForTf() - refused;
  EXPECT_EQ(answers, planes_->count());

  reconfigure([](PlaneSegmenterConfig&) {});
  const ros::Time stamp = nextStamp();
  publish(stamp);
  ASSERT_TRUE(planes_->waitFor(stamp, 1.0));
  EXPECT_EQ(1U, planes_->newest()->planes.size());
}

TEST_F(Frames, goesOnWithoutGravity) {
  reconfigure([](PlaneSegmenterConfig& config) {
    config.gravity_frame = config.fixed_frame = "nowhere";
    config.tf_patience = 1.0;
  });
  for (int i = 0; i < 5; ++i) {
    const ros::Time stamp = nextStamp();
    publish(stamp);
    // After a second, images no longer wait for unknown frames.
    ASSERT_TRUE(planes_->waitFor(stamp, i == 0 ? 2.0 : 0.5)) << i;
    ASSERT_EQ(1U, planes_->newest()->planes.size());
    EXPECT_EQ(Plane::UNKNOWN, planes_->newest()->planes[0].orientation);
  }
}

// As by rospy.wait_for_message: the transforms are there before the subscriber.
TEST_F(Frames, orientsTheFirstPlanesOfASubscriber) {
  sendStaticTransform();
  reconfigure([](PlaneSegmenterConfig& config) {
    config.gravity_frame = "still";
    config.publish_unknown = false;
  });
  for (int i = 0; i < 3; ++i) {
    unsubscribe();
    spinFor(i == 0 ? 1.0 : 0.1);
    ros::Time stamp = nextStamp();
    sendTransform("world", stamp);
    spinFor(0.1);
    subscribe();
    publish(stamp);
    ASSERT_TRUE(planes_->waitFor(stamp)) << i;
    ASSERT_EQ(1, planes_->count());
    EXPECT_TRUE(isOriented()) << i;
  }
}

// A static transform, which is latched, arrives some tenths of a second after the listener starts.
TEST_F(Frames, waitsForStaticTransformsOnce) {
  sendStaticTransform("still", "mounted_camera", cameraInWorld());
  image_.header.frame_id = "mounted_camera";
  reconfigure([](PlaneSegmenterConfig& config) {
    config.gravity_frame = "still";
    config.tf_patience = 0.0;
  });
  const ros::Time stamp = nextStamp();
  publish(stamp);
  ASSERT_TRUE(planes_->waitFor(stamp));
  EXPECT_TRUE(isOriented());
}

// Most transforms arrive shortly after their image.
TEST_F(Frames, waitsALittleForLateTransformsAndNotForever) {
  const auto in_the_world = [](PlaneSegmenterConfig& config) {
    config.target_frame = config.gravity_frame = "world";
    config.tf_patience = 0.5;
  };
  reconfigure(in_the_world);
  ASSERT_TRUE(answersSoon("world"));
  for (int i = 0; i < 3; ++i) {
    const ros::Time stamp = nextStamp();
    publish(stamp);
    EXPECT_FALSE(planes_->waitFor(stamp, 0.1));
    sendTransform("world", stamp);
    EXPECT_TRUE(planes_->waitFor(stamp)) << i;
  }
  const int refused = refusedUntilNow();
  const int answers = planes_->count();
  // Sent at 30 Hz: if each waited in turn, the last would wait for five seconds.
  for (int i = 0; i < 10; ++i) {
    publish(nextStamp());
    spinFor(1.0 / 30.0);
  }
  spinFor(0.6);
  const ros::Time stamp = nextStamp();
  sendTransform("world", stamp);
  publish(stamp);
  EXPECT_TRUE(planes_->waitFor(stamp, 0.5));
  EXPECT_EQ(answers + 1, planes_->count());
  EXPECT_TRUE(waitUntil([&] { return refusedForTf() == refused + 10; })) << refusedForTf() - refused;
}

// Then tf has no data for the new time until the first transform arrives, possibly after the image.
TEST_F(Frames, waitsWhereTimeHasGoneBack) {
  reconfigure([](PlaneSegmenterConfig& config) {
    config.target_frame = config.gravity_frame = "world";
    config.tf_patience = 0.5;
  });
  ASSERT_TRUE(answersSoon("world"));
  for (const double seconds : {500.0, 300.0}) {
    const ros::Time stamp(seconds);
    publish(stamp);
    EXPECT_FALSE(planes_->waitFor(stamp, 0.1));
    sendTransform("world", stamp);
    EXPECT_TRUE(planes_->waitFor(stamp)) << seconds;
  }
}

// The buffer is not emptied for a few images with old stamps: those of now keep their transforms.
TEST_F(Frames, keepsItsTransformsWhenImagesAreOld) {
  reconfigure([](PlaneSegmenterConfig& config) { config.target_frame = config.gravity_frame = "world"; });
  ASSERT_TRUE(answersSoon("world"));
  const ros::Time first = nextStamp(), last = nextStamp();
  sendTransform("world", first);
  sendTransform("world", last);
  publish(last);
  ASSERT_TRUE(planes_->waitFor(last));
  for (int i = 0; i < 8; ++i) publish(last - ros::Duration(20.0 - 0.1 * i));
  spinFor(1.0);
  const ros::Time between = first + ros::Duration(0.05);
  publish(between);
  EXPECT_TRUE(planes_->waitFor(between));
}

// A bag of 20 s played in a loop without a clock: tf is not notified that time jumps back.
TEST_F(Frames, goesOnWhenABagBeginsAgain) {
  sendStaticTransform();
  reconfigure([](PlaneSegmenterConfig& config) {
    config.target_frame = config.gravity_frame = config.fixed_frame = "still";
  });
  ASSERT_TRUE(answersSoon("world"));
  std::vector<std::vector<std::uint32_t>> ids(3);
  for (int loop = 0; loop < 3; ++loop) {
    for (int i = 0; i <= 20; ++i) {
      const ros::Time stamp(500.0 + i);
      sendTransform("world", stamp);
      // Sent after its transform has arrived.
      spinFor(0.03);
      publish(stamp);
      if (!planes_->waitFor(stamp, i == 0 ? 0.5 : 5.0)) continue;
      ASSERT_EQ(1U, planes_->newest()->planes.size());
      EXPECT_EQ("still", planes_->newest()->header.frame_id);
      EXPECT_EQ(Plane::HORIZONTAL_UP, planes_->newest()->planes[0].orientation);
      ids[static_cast<std::size_t>(loop)].push_back(planes_->newest()->planes[0].id);
    }
    EXPECT_GE(ids[static_cast<std::size_t>(loop)].size(), 20U) << "recovers within one frame";
    for (const std::uint32_t id : ids[static_cast<std::size_t>(loop)]) EXPECT_EQ(1U, id);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
