// SPDX-License-Identifier: BSD-3-Clause
// Rows 30 and 31: reconfigured at the highest possible rate during processing, also with invalid values.
// Each frame uses one consistent set of parameters, and none is delayed.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "reconfigure.h"
#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;
constexpr double kBetween = 2.0;  // [m] beyond the near wall, before the far one
constexpr double kFar = 10.0;     // [m]

using Range = std::vector<double>;  // min_range and max_range [m]

// The left quarter of the image shows a wall at 1 m, the rest a wall at 3 m.
sensor_msgs::Image twoWalls() {
  sensor_msgs::Image image = testImage(kWidth, kHeight, "16UC1");
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) setDepth(image, u, v, u < kWidth / 4 ? 1.0 : 3.0);
  }
  return image;
}

constexpr std::uint32_t kPixelsOfNearWall = kWidth * kHeight / 4;
constexpr std::uint32_t kPixelsOfFarWall = kWidth * kHeight - kPixelsOfNearWall;

// Represents another program, with its own thread.
class Storm {
 public:
  Storm() : thread_([this] { run(); }) {}
  ~Storm() { stop(); }
  Storm(const Storm&) = delete;
  Storm& operator=(const Storm&) = delete;

  // How many requests were answered so far.
  int answered() const { return answered_; }

  // @return number of answered requests
  int stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return answered_;
  }

 private:
  void run() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Range> ranges = {{0.3, kBetween}, {kBetween, kFar}, {nan, nan}};
    ros::NodeHandle nh;
    ros::ServiceClient client =
        nh.serviceClient<dynamic_reconfigure::Reconfigure>("plane_segmenter/set_parameters", true);
    for (std::size_t i = 0; !stop_; ++i) {
      const auto next = ros::SteadyTime::now() + ros::WallDuration(0.005);
      request(client, ranges[i % ranges.size()]);
      const ros::WallDuration rest = next - ros::SteadyTime::now();
      if (rest > ros::WallDuration(0.0)) rest.sleep();
    }
  }

  void request(ros::ServiceClient& client, const Range& range) {
    dynamic_reconfigure::Reconfigure call;
    setDouble(call, "min_range", range[0]);
    setDouble(call, "max_range", range[1]);
    ASSERT_TRUE(client.call(call));
    for (const auto& value : call.response.config.doubles)
      EXPECT_TRUE(std::isfinite(value.value)) << value.name;
    ++answered_;
  }

  std::atomic<bool> stop_{false};
  std::atomic<int> answered_{0};
  std::thread thread_;
};

TEST(ReconfigureStorm, leavesEachFrameOneSetOfParametersAndWaitsForNone) {
  constexpr int kFrames = 120;
  TestCamera camera;
  std::vector<std::uint32_t> valid_pixels;
  ros::NodeHandle nh;
  const ros::Subscriber planes =
      nh.subscribe<PlaneArray>("plane_segmenter/planes", 1000, [&](const PlaneArray::ConstPtr& answer) {
        EXPECT_EQ(1U, answer->planes.size());
        valid_pixels.push_back(answer->valid_pixels);
      });
  ASSERT_TRUE(camera.waitForSubscriber());
  const sensor_msgs::Image image = twoWalls();
  const sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);

  // Each frame comes after at least so many requests since the frame before, however fast the machine is.
  constexpr int kRequestsPerFrame = 2;
  Storm storm;
  for (int frame = 0; frame < kFrames; ++frame) {
    const int enough = storm.answered() + kRequestsPerFrame;
    spinFor(1.0 / 30.0);
    ASSERT_TRUE(waitUntil([&] { return storm.answered() >= enough; })) << storm.answered();
    camera.publish(image, info, ros::Time(1000.0 + 0.1 * frame));
  }
  EXPECT_TRUE(waitUntil([&] { return valid_pixels.size() == kFrames; })) << valid_pixels.size();
  const int requests = storm.stop();
  RecordProperty("requests_per_frame", requests / kFrames);
  EXPECT_GE(requests, kRequestsPerFrame * kFrames);
  int changes = 0;
  for (std::size_t i = 1; i < valid_pixels.size(); ++i)
    changes += valid_pixels[i] != valid_pixels[i - 1] ? 1 : 0;
  EXPECT_GT(changes, kFrames / 8);
  EXPECT_EQ((std::set<std::uint32_t>{kPixelsOfNearWall, kPixelsOfFarWall}),
            std::set<std::uint32_t>(valid_pixels.begin(), valid_pixels.end()));
}

}  // namespace
}  // namespace line_plane_segmentation
