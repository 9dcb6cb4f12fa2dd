// SPDX-License-Identifier: BSD-3-Clause
// Rows 27 and 58: the nodelet is loaded and unloaded repeatedly while images arrive at 30 Hz: no crash, no
// deadlock, no leak in the manager.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <nodelet/NodeletList.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "nodelet_calls.h"
#include "support/random.h"
#include "test_camera.h"
#include "test_process.h"

namespace line_plane_segmentation {
namespace {

class Reload : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(ros::service::waitForService("manager/load_nodelet", 15000)); }

  void publishNext() { camera_.publish(image_, info_, ros::Time(seconds_ += 1.0 / 30.0)); }

  // Publishes images at 30 Hz until one is answered.
  bool publishUntilAnswered() {
    const int answers = planes_.count();
    for (int frame = 0; frame < 300; ++frame) {
      publishNext();
      if (waitUntil([&] { return planes_.count() > answers; }, 1.0 / 30.0)) return true;
    }
    return false;
  }

  TestCamera camera_;
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  sensor_msgs::Image image_ = imageOfPlane(640, 480, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5);
  sensor_msgs::CameraInfo info_ = testInfo(640, 480);
  double seconds_ = 100.0;
};

TEST_F(Reload, worksEachTimeAndLeavesNothingBehind) {
  constexpr int kWarmUp = 20;
  const int rounds = ros::param::param("~rounds", 50);
  const int manager = processOfNode("/manager");
  int threads = 0, files = 0;
  double megabytes = 0.0;
  for (int round = 0; round < rounds; ++round) {
    if (round == kWarmUp) {
      threads = entriesOf(manager, "task");
      files = entriesOf(manager, "fd");
      megabytes = residentMegabytes(manager);
    }
    ASSERT_TRUE(loadSegmenter("/plane_segmenter")) << round;
    ASSERT_TRUE(publishUntilAnswered()) << round;
    // Unloads during a frame, at a different time in each round.
    for (int burst = 0; burst < 5; ++burst) publishNext();
    ros::WallDuration(0.001 * (round % 10)).sleep();
    ASSERT_TRUE(unloadSegmenter("/plane_segmenter")) << round;
  }
  EXPECT_TRUE(waitUntil([this] { return camera_.imageSubscribers() == 0; }));
  EXPECT_GT(threads, 1);
  // One may just be starting or ending.
  EXPECT_LE(entriesOf(manager, "task"), threads + 2);
  EXPECT_LE(entriesOf(manager, "fd"), files + 2);
#ifndef __SANITIZE_ADDRESS__  // which holds back what is freed
  EXPECT_LT(residentMegabytes(manager), megabytes + 10.0);
#endif
  RecordProperty("grown_kilobytes", static_cast<int>(1000.0 * (residentMegabytes(manager) - megabytes)));
  nodelet::NodeletList list;
  ASSERT_TRUE(ros::service::call("manager/list", list)) << "the manager is dead";
  EXPECT_TRUE(list.response.nodelets.empty());
}

// Noise half of which lies within the plane distance, and parameters that make a candidate of nearly every
// pixel: a frame takes many seconds.
TEST_F(Reload, givesASlowFrameUp) {
  Random random(1);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const auto millimetres = static_cast<std::uint16_t>(random.integer(1496, 1504));
      std::memcpy(&image_.data[static_cast<std::size_t>(v) * image_.step + 2U * static_cast<std::size_t>(u)],
                  &millimetres, sizeof(millimetres));
    }
  }
  ros::NodeHandle slow("/slow_segmenter");
  slow.setParam("preset", "paper");
  slow.setParam("scanline_spacing", 1);
  slow.setParam("points_per_segment", 5);
  slow.setParam("line_window", 5);
  slow.setParam("min_line_points", 10);
  slow.setParam("normal_window", 6);
  slow.setParam("min_window_points", 6);
  slow.setParam("max_curvature", 0.33);
  slow.setParam("min_plane_inliers", 1);
  slow.setParam("plane_distance", 0.002);
  slow.setParam("neighbor_distance", 0.2);
  ASSERT_TRUE(loadSegmenter("/slow_segmenter"));
  const Inbox<PlaneArray> planes("slow_segmenter/planes");
  ASSERT_TRUE(waitUntil([this] { return camera_.imageSubscribers() > 0; }));
  const Inbox<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  const auto is_reported = [&diagnostics] {
    const auto report = diagnostics.newest();
    return report && std::any_of(report->status.begin(), report->status.end(), [](const auto& status) {
             return status.name.find("slow_segmenter") != std::string::npos &&
                    status.message.find("the current frame has taken") != std::string::npos;
           });
  };
  publishNext();
  EXPECT_TRUE(waitUntil(is_reported, 20.0));
  EXPECT_TRUE(unloadSegmenter("/slow_segmenter"));
  spinFor(0.5);
  EXPECT_EQ(0, planes.count()) << "the frame was processed to its end";
}

}  // namespace
}  // namespace line_plane_segmentation
