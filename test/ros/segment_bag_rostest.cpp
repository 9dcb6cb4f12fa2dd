// SPDX-License-Identifier: BSD-3-Clause
// segment_bag writes the same messages as the running segmenter publishes, bit by bit.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <string>
#include <vector>

#include "simulated_camera.h"
#include "test_camera.h"
#include "tools/temporary_folder.h"
#include "tools/test_bag.h"
#include "tools/tool_process.h"

namespace line_plane_segmentation {
namespace {

constexpr int kFrames = 12;
constexpr int kWidth = 320;
constexpr int kHeight = 240;

// Not compared: the processing time, and the sequence number that roscpp assigns.
void forgetTheWay(PlaneArray& message) {
  message.header.seq = 0;
  message.processing_time = 0.0F;
  message.processing_seconds = 0.0;
}
void forgetTheWay(visualization_msgs::MarkerArray& message) {
  for (auto& marker : message.markers) marker.header.seq = 0;
}
template <typename Message>
void forgetTheWay(Message& message) {
  message.header.seq = 0;
}

/// Messages of one topic of the running segmenter.
template <typename Message>
class Record {
 public:
  explicit Record(const std::string& name) : topic_("/camera/plane_segmenter/" + name) {
    ros::NodeHandle nh;
    subscriber_ = nh.subscribe<Message>(
        topic_, kFrames,
        [this](const boost::shared_ptr<const Message>& message) { live_.push_back(normalised(*message)); });
  }

  std::size_t size() const { return live_.size(); }
  void clear() { live_.clear(); }

  void expectSameIn(const std::filesystem::path& bag) const {
    SCOPED_TRACE(topic_);
    std::vector<std::string> offline;
    const auto messages = readAll<Message>(bag);
    for (const auto& message : messages.at(topic_)) offline.push_back(normalised(*message));
    ASSERT_EQ(live_.size(), offline.size());
    for (std::size_t i = 0; i < live_.size(); ++i) EXPECT_TRUE(live_[i] == offline[i]) << "frame " << i;
  }

 private:
  static std::string normalised(Message message) {
    forgetTheWay(message);
    return bytesOf(message);
  }

  std::string topic_;
  ros::Subscriber subscriber_;
  std::vector<std::string> live_;
};

// A camera that moves through a furnished room, so that planes appear and disappear.
sensor_msgs::Image pictureOf(simulation::SimulatedCamera& room, int i) {
  sensor_msgs::Image image = testImage(kWidth, kHeight, "16UC1");
  room.capture(static_cast<std::uint64_t>(i), 0.25 * i, reinterpret_cast<std::uint16_t*>(image.data.data()));
  return image;
}

tf2_msgs::TFMessage placeOf(const simulation::SimulatedCamera& room, int i) {
  const Eigen::Isometry3d pose = room.pose(0.25 * i);
  const Eigen::Quaterniond rotation(pose.linear());
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stampOf(i);
  transform.header.frame_id = "world";
  transform.child_frame_id = kCameraFrame;
  transform.transform.translation.x = pose.translation().x();
  transform.transform.translation.y = pose.translation().y();
  transform.transform.translation.z = pose.translation().z();
  transform.transform.rotation.w = rotation.w();
  transform.transform.rotation.x = rotation.x();
  transform.transform.rotation.y = rotation.y();
  transform.transform.rotation.z = rotation.z();
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

TEST(SegmentBag, givesWhatTheRunningSegmenterPublishes) {
  Record<PlaneArray> planes("planes");
  Record<sensor_msgs::Image> labels("labels"), overlay("overlay");
  Record<sensor_msgs::PointCloud2> cloud("cloud");
  Record<visualization_msgs::MarkerArray> markers("markers"), scanlines("scanlines");
  TestCamera camera;
  ASSERT_TRUE(camera.waitForSubscriber());
  ros::NodeHandle nh;
  const ros::Publisher transforms = nh.advertise<tf2_msgs::TFMessage>("/tf", 10);
  ASSERT_TRUE(waitUntil([&] { return transforms.getNumSubscribers() > 0; }));

  // Publishes until the segmenter knows all subscribers. Images this old do not affect the ids.
  const auto count = [&] {
    return std::min(
        {planes.size(), labels.size(), overlay.size(), cloud.size(), markers.size(), scanlines.size()});
  };
  ros::Time long_ago(10.0);
  ASSERT_TRUE(waitUntil([&] {
    camera.publish(testImage(kWidth, kHeight, "16UC1"), testInfo(kWidth, kHeight),
                   long_ago += ros::Duration(0.1));
    spinFor(0.1);
    return count() > 0;
  }));
  spinFor(2.0);
  planes.clear();
  labels.clear();
  overlay.clear();
  cloud.clear();
  markers.clear();
  scanlines.clear();

  const TemporaryFolder folder;
  const std::string in = (folder / "in.bag").string();
  const std::string out = (folder / "out.bag").string();
  rosbag::Bag bag(in, rosbag::bagmode::Write);
  simulation::SimulatedCamera room({3, kWidth, kHeight, true});
  // Once tf knows the frame, images wait for late transforms.
  bag.write("/tf", recordingTime(-1), placeOf(room, -1));
  transforms.publish(placeOf(room, -1));
  spinFor(0.5);
  for (int i = 0; i < kFrames; ++i) {
    sensor_msgs::Image image = pictureOf(room, i);
    sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);
    image.header.stamp = info.header.stamp = stampOf(i);
    bag.write("/camera/depth/image_rect", recordingTime(i), image);
    // After the image, as usual.
    bag.write("/tf", recordingTime(i) + ros::Duration(0.02), placeOf(room, i));
    bag.write("/camera/depth/camera_info", recordingTime(i), info);
    camera.publish(image, info, image.header.stamp);
    transforms.publish(placeOf(room, i));
    ASSERT_TRUE(waitUntil([&] { return count() == static_cast<std::size_t>(i) + 1; })) << "frame " << i;
  }
  bag.close();

  const ToolResult result = runProcess(SEGMENT_BAG, {in, out, "--all", "--set", "gravity_frame=world",
                                                     "--set", "fixed_frame=world", "--set", "tf_patience=1"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  planes.expectSameIn(out);
  const auto messages = readAll<PlaneArray>(out);
  const PlaneArray& last = *messages.at("/camera/plane_segmenter/planes").back();
  ASSERT_FALSE(last.planes.empty());
  EXPECT_NE(last.planes.front().orientation, Plane::UNKNOWN) << "no transforms were heeded";
  labels.expectSameIn(out);
  overlay.expectSameIn(out);
  cloud.expectSameIn(out);
  markers.expectSameIn(out);
  scanlines.expectSameIn(out);
}

}  // namespace
}  // namespace line_plane_segmentation
