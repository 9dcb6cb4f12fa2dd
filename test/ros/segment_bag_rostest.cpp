// SPDX-License-Identifier: BSD-3-Clause
// What segment_bag writes is what the running segmenter publishes, bit by bit.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "line_plane_segmentation/simulation/simulated_camera.h"
#include "test_camera.h"
#include "tools/temporary_folder.h"
#include "tools/test_bag.h"
#include "tools/tool_process.h"

namespace line_plane_segmentation {
namespace {

constexpr int kFrames = 12;
constexpr int kWidth = 320;
constexpr int kHeight = 240;

// Not compared: how long it took, and the number that roscpp gives a message when it sends it.
void forgetTheWay(PlaneArray& message) {
  message.header.seq = 0;
  message.processing_time = 0.0F;
}
void forgetTheWay(visualization_msgs::MarkerArray& message) {
  for (auto& marker : message.markers) marker.header.seq = 0;
}
template <typename Message>
void forgetTheWay(Message& message) {
  message.header.seq = 0;
}

/// What came of one topic of the running segmenter.
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

// A camera on its way through a furnished room, so that planes come and go.
sensor_msgs::Image pictureOf(simulation::SimulatedCamera& room, int i) {
  sensor_msgs::Image image = testImage(kWidth, kHeight, "16UC1");
  room.capture(static_cast<std::uint64_t>(i), 0.25 * i, reinterpret_cast<std::uint16_t*>(image.data.data()));
  return image;
}

TEST(SegmentBag, givesWhatTheRunningSegmenterPublishes) {
  const Record<PlaneArray> planes("planes");
  const Record<sensor_msgs::Image> labels("labels"), overlay("overlay");
  const Record<sensor_msgs::PointCloud2> cloud("cloud");
  const Record<visualization_msgs::MarkerArray> markers("markers");
  TestCamera camera;
  ASSERT_TRUE(camera.waitForSubscriber());
  spinFor(0.5);  // until the segmenter knows of all of the subscribers

  const TemporaryFolder folder;
  const std::string in = (folder / "in.bag").string();
  const std::string out = (folder / "out.bag").string();
  rosbag::Bag bag(in, rosbag::bagmode::Write);
  simulation::SimulatedCamera room({3, kWidth, kHeight, true});
  for (int i = 0; i < kFrames; ++i) {
    sensor_msgs::Image image = pictureOf(room, i);
    sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);
    image.header.stamp = info.header.stamp = stampOf(i);
    bag.write("/camera/depth/image_rect", recordingTime(i), image);
    bag.write("/camera/depth/camera_info", recordingTime(i), info);
    camera.publish(image, info, image.header.stamp);
    const auto count = static_cast<std::size_t>(i) + 1;
    ASSERT_TRUE(waitUntil([&] {
      return planes.size() == count && labels.size() == count && overlay.size() == count &&
             cloud.size() == count && markers.size() == count;
    })) << "frame "
        << i;
  }
  bag.close();

  const ToolResult result = runProcess(SEGMENT_BAG, {in, out, "--all"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  planes.expectSameIn(out);
  labels.expectSameIn(out);
  overlay.expectSameIn(out);
  cloud.expectSameIn(out);
  markers.expectSameIn(out);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "segment_bag_rostest");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
