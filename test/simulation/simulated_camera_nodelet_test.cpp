// SPDX-License-Identifier: BSD-3-Clause
// The nodelet in this very process, as in a manager: its messages arrive without a copy, and what it costs
// can be measured.
#include <gtest/gtest.h>
#include <image_transport/image_transport.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>
#include <sys/resource.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace line_plane_segmentation {
namespace {

const std::string kName = "/cam/simulated_camera";

/// Handles callbacks until `done` or the time [s] is up.
bool spinUntil(const std::function<bool()>& done, double seconds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!done() && ros::WallTime::now() < end && ros::ok()) {
    ros::spinOnce();
    ros::WallDuration(0.002).sleep();
  }
  return done();
}

void spinFor(double seconds) {
  spinUntil([] { return false; }, seconds);
}

/// Processor time that this process has used [s].
double processorTime() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::uint64_t checksum(const sensor_msgs::Image& image) {
  return std::accumulate(image.data.begin(), image.data.end(), std::uint64_t{0},
                         [](std::uint64_t sum, std::uint8_t byte) { return sum * 31 + byte; });
}

std::vector<std::uint16_t> pixelsOf(const sensor_msgs::Image& image) {
  std::vector<std::uint16_t> pixels(image.data.size() / 2);
  std::memcpy(pixels.data(), image.data.data(), image.data.size());
  return pixels;
}

class SimulatedCameraNodelet : public ::testing::Test {
 protected:
  struct Frame {
    sensor_msgs::ImageConstPtr image;
    sensor_msgs::CameraInfoConstPtr info;
  };

  ~SimulatedCameraNodelet() override {
    loader_.clear();
    ros::param::del(kName);
  }

  template <typename Value>
  void set(const std::string& parameter, const Value& value) {
    ros::param::set(kName + "/" + parameter, value);
  }

  void load() { ASSERT_TRUE(loader_.load(kName, "line_plane_segmentation/simulated_camera", {}, {})); }
  void unload() { ASSERT_TRUE(loader_.unload(kName)); }

  void subscribe() {
    depth_subscriber_ = image_transport::ImageTransport(nh_).subscribeCamera(
        "/cam/depth/image_raw", 10,
        [this](const sensor_msgs::ImageConstPtr& image, const sensor_msgs::CameraInfoConstPtr& info) {
          frames_.push_back({image, info});
        });
  }

  void subscribeLabels() {
    labels_subscriber_ = nh_.subscribe<sensor_msgs::Image>(
        "/cam/depth/labels", 10,
        [this](const sensor_msgs::ImageConstPtr& image) { labels_.push_back(image); });
  }

  bool waitForFrames(std::size_t count) {
    return spinUntil([&] { return frames_.size() >= count; }, 10.0);
  }

  ros::NodeHandle nh_;
  std::vector<Frame> frames_;
  std::vector<sensor_msgs::ImageConstPtr> labels_;
  image_transport::CameraSubscriber depth_subscriber_;
  ros::Subscriber labels_subscriber_;
  nodelet::Loader loader_{false};
};

TEST_F(SimulatedCameraNodelet, PublishesThirtyConsistentFramesASecond) {
  load();
  subscribe();
  ASSERT_TRUE(waitForFrames(61));
  const double seconds = (frames_[60].image->header.stamp - frames_[0].image->header.stamp).toSec();
  EXPECT_NEAR(60.0 / seconds, 30.0, 8.0);

  ros::Time last;
  for (const auto& [image, info] : frames_) {
    EXPECT_GT(image->header.stamp, last);
    last = image->header.stamp;
    EXPECT_EQ(image->header.frame_id, "camera_depth_optical_frame");
    EXPECT_EQ(image->encoding, sensor_msgs::image_encodings::TYPE_16UC1);
    EXPECT_EQ(image->width, 640U);
    EXPECT_EQ(image->height, 480U);
    EXPECT_EQ(image->step, 1280U);
    EXPECT_EQ(image->data.size(), 1280U * 480U);
    EXPECT_EQ(info->header.stamp, image->header.stamp);
    EXPECT_EQ(info->header.frame_id, image->header.frame_id);
    EXPECT_EQ(info->width, image->width);
    EXPECT_EQ(info->height, image->height);
    EXPECT_EQ(info->K[0], 525.0);
    EXPECT_EQ(info->K[2], 319.5);
    EXPECT_EQ(info->K[4], 525.0);
    EXPECT_EQ(info->K[5], 239.5);
    EXPECT_EQ(info->P[0], info->K[0]);
    EXPECT_EQ(info->P[5], info->K[4]);
    EXPECT_EQ(info->P[6], info->K[5]);
    EXPECT_EQ(info->P[10], 1.0);
  }
  const std::vector<std::uint16_t> pixels = pixelsOf(*frames_.back().image);
  EXPECT_LT(std::count(pixels.begin(), pixels.end(), 0), 640 * 480 / 4);
  EXPECT_LT(*std::max_element(pixels.begin(), pixels.end()), 10001) << "not millimetres in a room";
}

TEST_F(SimulatedCameraNodelet, NeverTouchesWhatItHasPublished) {
  load();
  subscribe();
  ASSERT_TRUE(waitForFrames(5));
  std::vector<std::uint64_t> sums;
  for (std::size_t i = 0; i < 5; ++i) sums.push_back(checksum(*frames_[i].image));
  ASSERT_TRUE(waitForFrames(30));
  std::set<const std::uint8_t*> addresses;
  for (const Frame& frame : frames_) addresses.insert(frame.image->data.data());
  EXPECT_EQ(addresses.size(), frames_.size());
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(checksum(*frames_[i].image), sums[i]);
  EXPECT_EQ(std::set<std::uint64_t>(sums.begin(), sums.end()).size(), 5U) << "the picture stands still";
}

TEST_F(SimulatedCameraNodelet, FollowsItsParameters) {
  set("width", 320);
  set("rate", 100);
  set("frame_id", "eye");
  set("noise", false);
  load();
  subscribe();
  ASSERT_TRUE(waitForFrames(50));
  EXPECT_EQ(frames_[0].image->width, 320U);
  EXPECT_EQ(frames_[0].image->height, 240U);
  EXPECT_EQ(frames_[0].info->K[0], 262.5);
  EXPECT_EQ(frames_[0].image->header.frame_id, "eye");
  // The default rate would give at least 33 ms. On a busy machine frames may be late, but not all of them.
  double shortest = 1.0;  // [s]
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    shortest =
        std::min(shortest, (frames_[i].image->header.stamp - frames_[i - 1].image->header.stamp).toSec());
  }
  EXPECT_LT(shortest, 0.02);
}

TEST_F(SimulatedCameraNodelet, TellsWhereTheVerticalIs) {
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  load();
  subscribe();
  ASSERT_TRUE(waitForFrames(20));
  const std_msgs::Header header = frames_.back().image->header;
  ASSERT_TRUE(spinUntil([&] { return buffer.canTransform("world", header.frame_id, header.stamp); }, 5.0));
  const auto transform = buffer.lookupTransform("world", header.frame_id, header.stamp).transform;
  EXPECT_NEAR(transform.translation.z, 1.4, 0.5);
  const auto& q = transform.rotation;
  const double height_of_image_up = -2.0 * (q.y * q.z + q.w * q.x);  // z of the rotated (0, -1, 0)
  EXPECT_GT(height_of_image_up, 0.6) << "the picture is not upright";
}

TEST_F(SimulatedCameraNodelet, GivesLabelsWhileSomebodyWantsThem) {
  load();
  subscribeLabels();
  ASSERT_TRUE(spinUntil([&] { return labels_.size() >= 3; }, 10.0)) << "labels alone";
  subscribe();
  ASSERT_TRUE(waitForFrames(10));
  spinFor(0.2);
  std::set<ros::Time> stamps;
  for (const auto& image : labels_) stamps.insert(image->header.stamp);
  EXPECT_GE(std::count_if(frames_.begin(), frames_.end(),
                          [&](const Frame& frame) { return stamps.count(frame.image->header.stamp) > 0; }),
            8);
  const sensor_msgs::Image& image = *labels_.back();
  EXPECT_EQ(image.encoding, sensor_msgs::image_encodings::TYPE_16UC1);
  EXPECT_EQ(image.width, 640U);
  EXPECT_EQ(image.data.size(), 640U * 480U * 2U);
  const std::vector<std::uint16_t> pixels = pixelsOf(image);
  EXPECT_GT(std::set<std::uint16_t>(pixels.begin(), pixels.end()).size(), 4U);
}

TEST_F(SimulatedCameraNodelet, RendersNothingWhileNobodyLooks) {
  const auto cost_of_two_seconds = [] {
    const double before = processorTime();
    spinFor(2.0);
    return processorTime() - before;
  };
  set("width", 1280);
  load();
  const double before_anybody = cost_of_two_seconds();
  subscribe();
  ASSERT_TRUE(waitForFrames(1));
  const double while_looking = cost_of_two_seconds();
  depth_subscriber_.shutdown();
  spinFor(0.3);
  const double after_all_left = cost_of_two_seconds();
  EXPECT_LT(before_anybody, 0.3 * while_looking);
  EXPECT_LT(after_all_left, 0.3 * while_looking);
}

TEST_F(SimulatedCameraNodelet, CanBeUnloadedAtAnyTime) {
  set("width", 160);
  set("rate", 500);
  for (int round = 0; round < 30; ++round) {
    load();
    if (round == 0) subscribe();
    frames_.clear();
    ASSERT_TRUE(waitForFrames(3)) << "round " << round;
    unload();
    spinFor(0.05);
    const std::size_t received = frames_.size();
    spinFor(0.05);
    EXPECT_EQ(frames_.size(), received) << "round " << round;
  }
}

TEST_F(SimulatedCameraNodelet, StaysIdleWithWrongParametersAndLivesOn) {
  const auto expect_nothing = [this] {
    load();
    subscribe();
    spinFor(0.5);
    EXPECT_TRUE(frames_.empty());
    EXPECT_EQ(depth_subscriber_.getNumPublishers(), 0U);
    depth_subscriber_.shutdown();
    unload();
    ros::param::del(kName);
  };
  set("width", std::string("wide"));
  expect_nothing();
  set("width", 0);
  expect_nothing();
  set("height", 100000);
  expect_nothing();
  set("rate", -30.0);
  expect_nothing();
  set("rate", 0);
  expect_nothing();
  set("noise", 3);
  expect_nothing();
  set("frame_id", std::string());
  expect_nothing();

  load();
  subscribe();
  EXPECT_TRUE(waitForFrames(3)) << "a good camera after the bad ones";
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulated_camera_nodelet_test");
  ros::NodeHandle keeps_the_node_alive;
  return RUN_ALL_TESTS();
}
