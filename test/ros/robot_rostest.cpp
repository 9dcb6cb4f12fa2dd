// SPDX-License-Identifier: BSD-3-Clause
// Obstacles, objects and fused planes from a simulated camera that walks through a furnished room.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <line_plane_segmentation/SupportedObjectArray.h>
#include <line_plane_segmentation/TrackedPlaneArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_ros/transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "reconfigure.h"
#include "simulated_camera.h"
#include "simulated_frames.h"
#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr std::uint64_t kSeed = 3;

int count(const visualization_msgs::MarkerArray& markers, const std::string& name_space) {
  return static_cast<int>(std::count_if(markers.markers.begin(), markers.markers.end(),
                                        [&](const auto& marker) { return marker.ns == name_space; }));
}

class Robot : public testing::Test {
 protected:
  Robot() {
    static int tests = 0;
    start_ = 1000.0 + 100.0 * tests++;  // stamps that go back would reset tf
    EXPECT_TRUE(camera_.waitForSubscriber());
    reconfigure([](PlaneSegmenterConfig& config) {
      config.target_frame = "";
      config.gravity_frame = config.fixed_frame = "world";
      config.tf_patience = 1.0;
    });
  }

  void sendPose(int second) {
    geometry_msgs::TransformStamped message = tf2::eigenToTransform(path_.pose(second));
    message.header.stamp = stamp_;
    message.header.frame_id = "world";
    message.child_frame_id = kCameraFrame;
    broadcaster_.sendTransform(message);
  }

  // Publishes an image until the segmenter has received the camera's pose, and the outputs are connected.
  // Each attempt has a stamp of its own.
  template <typename... Inboxes>
  bool show(int second, const Inboxes&... outputs) {
    const TestFrame& frame = frames_[static_cast<std::size_t>(second)];
    int attempt = 0;
    return waitUntil([&] {
      stamp_ = ros::Time(start_ + second + 0.01 * attempt++);
      sendPose(second);
      camera_.publish(frame.image, frame.info, stamp_);
      if (!planes_.waitFor(stamp_, 1.0) || planes_.newest()->planes.empty()) return false;
      if (planes_.newest()->planes[0].orientation == Plane::UNKNOWN) return false;
      return (outputs.waitFor(stamp_, 0.2) && ...);
    });
  }

  double start_ = 0.0;  // [s] stamp of the path's beginning
  ros::Time stamp_;     // of the last image
  TestCamera camera_;
  tf2_ros::TransformBroadcaster broadcaster_;
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  simulation::SimulatedCamera path_{{kSeed, kWidth, kHeight, true}};
  std::vector<TestFrame> frames_ = simulatedFrames(kSeed, 4, kWidth, kHeight);
};

TEST_F(Robot, leavesTheFloorAloneOutOfTheObstacles) {
  const Inbox<sensor_msgs::PointCloud2> obstacles("plane_segmenter/cloud_without_planes");
  ASSERT_TRUE(show(0, obstacles));
  const sensor_msgs::PointCloud2& cloud = *obstacles.newest();
  EXPECT_EQ(kCameraFrame, cloud.header.frame_id);
  EXPECT_TRUE(cloud.is_dense);
  EXPECT_EQ(1U, cloud.height);

  std::set<std::uint32_t> floors, others, found;
  const Eigen::Isometry3d pose = path_.pose(0.0);
  for (const Plane& plane : planes_.newest()->planes) {
    const double height = (pose * Eigen::Vector3d(plane.centroid.x, plane.centroid.y, plane.centroid.z)).z();
    const bool is_floor = plane.orientation == Plane::HORIZONTAL_UP && std::abs(height) < 0.1;
    (is_floor ? floors : others).insert(plane.id);
  }
  ASSERT_FALSE(floors.empty());
  ASSERT_FALSE(others.empty());
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> id(cloud, "id");
  sensor_msgs::PointCloud2ConstIterator<float> z(cloud, "z");
  for (; id != id.end(); ++id, ++z) {
    EXPECT_TRUE(std::isfinite(*z));
    if (*id != 0) found.insert(*id);
  }
  EXPECT_EQ(others, found) << "all planes but the floor";
}

TEST_F(Robot, findsObjectsOnTheTableAndDrawsThem) {
  const Inbox<SupportedObjectArray> objects("plane_segmenter/objects");
  const Inbox<visualization_msgs::MarkerArray> markers("plane_segmenter/markers");
  ASSERT_TRUE(show(1, objects));
  const SupportedObjectArray& array = *objects.newest();
  ASSERT_FALSE(array.objects.empty());
  std::set<std::uint32_t> supports(array.support_ids.begin(), array.support_ids.end());
  for (const SupportedObject& object : array.objects) {
    EXPECT_EQ(1U, supports.count(object.support_id));
    EXPECT_GT(object.box_size.z, 0.01);
    EXPECT_LE(object.box_size.z, 0.5);
    EXPECT_GE(object.box_size.x, object.box_size.y);
    EXPECT_LE(object.first_column + object.columns, static_cast<std::uint32_t>(kWidth));
  }
  ASSERT_TRUE(
      waitUntil([&] { return markers.newest() && markers.newest()->markers.at(0).header.stamp == stamp_; }));
  EXPECT_EQ(static_cast<int>(array.objects.size()), count(*markers.newest(), "objects"));
}

TEST_F(Robot, fusesPlanesInTheFixedFrame) {
  const Inbox<TrackedPlaneArray> tracked("plane_segmenter/tracked_planes");
  for (int second = 0; second < 4; ++second) ASSERT_TRUE(show(second, tracked));
  const TrackedPlaneArray& array = *tracked.newest();
  EXPECT_EQ("world", array.header.frame_id);
  std::set<std::uint32_t> visible;
  bool is_floor_found = false;
  for (const TrackedPlane& track : array.planes) {
    if (track.visible) visible.insert(track.plane.id);
    EXPECT_EQ(track.visible, track.plane.label != 0);
    EXPECT_EQ(track.visible, track.last_seen == array.header.stamp);
    EXPECT_EQ(array.header.stamp - track.first_seen, track.age);
    EXPECT_FALSE(track.plane.outline.points.empty()) << "kept while it is not visible";
    const auto& coef = track.plane.coefficients.coef;
    for (const auto& point : track.plane.outline.points) {
      EXPECT_NEAR(0.0,
                  coef[0] * static_cast<double>(point.x) + coef[1] * static_cast<double>(point.y) +
                      coef[2] * static_cast<double>(point.z) + coef[3],
                  1e-4);
    }
    if (track.plane.orientation != Plane::HORIZONTAL_UP || std::abs(coef[3]) > 0.1) continue;
    is_floor_found = true;
    EXPECT_GE(track.observations, 3U);
    EXPECT_GT(coef[2], std::cos(0.3 * M_PI / 180.0));
    EXPECT_NEAR(0.0, coef[3], 0.02);
  }
  EXPECT_TRUE(is_floor_found);
  std::set<std::uint32_t> ids;
  for (const Plane& plane : planes_.newest()->planes) ids.insert(plane.id);
  EXPECT_EQ(ids, visible);
}

TEST_F(Robot, fusesNothingWithoutAFixedFrame) {
  reconfigure([](PlaneSegmenterConfig& config) { config.gravity_frame = "world"; });
  const Inbox<TrackedPlaneArray> tracked("plane_segmenter/tracked_planes");
  ASSERT_TRUE(show(2));
  spinFor(0.3);
  EXPECT_EQ(nullptr, tracked.newest());
}

}  // namespace
}  // namespace line_plane_segmentation
