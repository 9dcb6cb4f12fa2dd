// SPDX-License-Identifier: BSD-3-Clause
// Row 36: ~frames frames of different rooms, sizes and encodings, some of them invalid, sent as fast as
// they are answered. Memory, threads and open files of the segmenter's process do not grow after warm-up,
// every valid frame is answered, and the log is throttled.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <ros/callback_queue.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdio>
#include <random>
#include <vector>

#include "simulated_frames.h"
#include "test_camera.h"
#include "test_process.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

/// Resources in use by the segmenter's process while idle.
struct Usage {
  int frames = 0;
  double megabytes = 0.0;
  int threads = 0, files = 0;
};

std::vector<TestFrame> goodFrames() {
  std::vector<TestFrame> frames;
  const auto add = [&](const std::vector<TestFrame>& more) {
    frames.insert(frames.end(), more.begin(), more.end());
  };
  for (const std::uint64_t room : {1U, 2U, 3U, 4U}) add(simulatedFrames(room, 5, 640, 480));
  add(simulatedFrames(5, 3, 640, 480, "32FC1"));
  add(simulatedFrames(6, 3, 320, 240));
  add(simulatedFrames(7, 1, 641, 479, "mono16"));
  add(simulatedFrames(8, 1, 1280, 720));
  frames.push_back({testImage(640, 480, "16UC1"), testInfo(640, 480)});
  frames.push_back({testImage(1, 1, "16UC1"), testInfo(1, 1)});
  TestFrame noise{testImage(640, 480, "16UC1"), testInfo(640, 480)};
  std::mt19937 random;
  for (std::uint8_t& byte : noise.image.data) byte = static_cast<std::uint8_t>(random() % 16);
  frames.push_back(noise);
  return frames;
}

std::vector<TestFrame> badFrames() {
  const TestFrame good{testImage(640, 480, "16UC1"), testInfo(640, 480)};
  std::vector<TestFrame> frames(6, good);
  frames[0].image.data.resize(1000);
  frames[1].image.width = 0;
  frames[2].image.step = 7;
  frames[3].image.encoding = "rgb8";
  frames[4].info.width = 320;
  frames[5].info.K[0] = frames[5].info.P[0] = 0.0;
  return frames;
}

class Soak : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(camera_.waitForSubscriber()); }

  // Two frames are always pending, so that the segmenter never waits.
  bool waitUntilUnderWay(int most) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(15.0);
    while (ros::ok() && sent_ - planes_.count() > most && ros::WallTime::now() < end) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    }
    return sent_ - planes_.count() <= most;
  }

  void publish(const TestFrame& frame) {
    camera_.publish(frame.image, frame.info, ros::Time(seconds_ += 0.01));
  }

  void sendNext() {
    if (sent_ % 10 == 0) publish(bad_[static_cast<std::size_t>(sent_ / 10) % bad_.size()]);
    publish(good_[static_cast<std::size_t>(sent_) % good_.size()]);
    ++sent_;
    ASSERT_TRUE(waitUntilUnderWay(2)) << "no answer to frame " << sent_;
  }

  void send(int frames) {
    for (int i = 0; i < frames && !HasFatalFailure(); ++i) sendNext();
  }

  // For some frames all outputs have a subscriber.
  void sendWithAllOutputs(int frames) {
    const Inbox<sensor_msgs::Image> labels("plane_segmenter/labels"), overlay("plane_segmenter/overlay");
    const Inbox<sensor_msgs::PointCloud2> cloud("plane_segmenter/cloud");
    const Inbox<visualization_msgs::MarkerArray> markers("plane_segmenter/markers"),
        scanlines("plane_segmenter/scanlines");
    send(frames);
    EXPECT_TRUE(waitUntil([&] {
      send(1);
      return labels.count() > 0 && overlay.count() > 0 && cloud.count() > 0 && markers.count() > 0 &&
             scanlines.count() > 0;
    }));
  }

  Usage usageAtRest(int process) {
    EXPECT_TRUE(waitUntilUnderWay(0));
    spinFor(0.1);
    return {sent_, residentMegabytes(process), entriesOf(process, "task"), entriesOf(process, "fd")};
  }

  TestCamera camera_;
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  Diagnostics diagnostics_;
  LogLines log_;
  const std::vector<TestFrame> good_ = goodFrames(), bad_ = badFrames();
  int sent_ = 0;
  double seconds_ = 1000.0;  // of the newest stamp
};

TEST_F(Soak, nothingGrows) {
  constexpr int kSamples = 20;
  constexpr double kMostGrowth = 1.0;  // [MB]
  const int frames = ros::param::param("~frames", 2000);
  const int process = processThatPublishes("/plane_segmenter/planes");
  const ros::WallTime start = ros::WallTime::now();

  std::vector<Usage> samples;
  std::printf("%9s %10s %8s %6s %9s\n", "frames", "memory/MB", "threads", "files", "seconds");
  while (static_cast<int>(samples.size()) < kSamples) {
    sendWithAllOutputs(frames / kSamples / 5);
    ASSERT_NO_FATAL_FAILURE(send(frames * (static_cast<int>(samples.size()) + 1) / kSamples - sent_));
    samples.push_back(usageAtRest(process));
    const Usage& usage = samples.back();
    std::printf("%9d %10.1f %8d %6d %9.1f\n", usage.frames, usage.megabytes, usage.threads, usage.files,
                (ros::WallTime::now() - start).toSec());
    std::fflush(stdout);
  }

  const auto warm = samples.cbegin() + kSamples / 4;
  const double growth = samples.back().megabytes - warm->megabytes;
  std::printf("since a quarter of them it has grown by %.2f MB\n", growth);
  EXPECT_GT(warm->megabytes, 10.0);
  EXPECT_LT(growth, kMostGrowth);
  for (auto usage = warm; usage != samples.cend(); ++usage) {
    EXPECT_EQ(warm->threads, usage->threads) << "after " << usage->frames << " frames";
    EXPECT_EQ(warm->files, usage->files) << "after " << usage->frames << " frames";
  }

  EXPECT_EQ(sent_, planes_.count());
  EXPECT_TRUE(diagnostics_.waitForReport());
  EXPECT_EQ("0", diagnostics_.value("frames dropped"));
  EXPECT_EQ("0", diagnostics_.value("frames failed"));
  // Each refusal reason at most once in 5 s, plus the one-time warnings.
  const double seconds = (ros::WallTime::now() - start).toSec();
  EXPECT_LE(log_.warnings("refused a frame"), static_cast<double>(bad_.size()) * (seconds / 5.0 + 1.0));
  EXPECT_GE(log_.warnings("refused a frame"), static_cast<int>(bad_.size()));
}

}  // namespace
}  // namespace line_plane_segmentation
