// SPDX-License-Identifier: BSD-3-Clause
// Row 33: images arrive three times as fast as they are processed, which a dense grid of scanlines slows
// down. The newest are processed; every other one is dropped and counted. Latency and memory stay bounded,
// and normal operation resumes afterwards.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/median.h"
#include "test_camera.h"
#include "test_process.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr int kQueueSize = 40;  // as in overload.test

class Overload : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(camera_.waitForSubscriber()); }

  // The timestamp of an image is the time of sending.
  ros::Time publishNow() {
    const ros::Time stamp(now());
    camera_.publish(image_, info_, stamp);
    ++published_;
    return stamp;
  }

  void take(const PlaneArray& answer) {
    const double time = now();
    ++answered_;
    stamps_.push_back(answer.header.stamp);
    ages_.push_back(time - answer.header.stamp.toSec());
    processing_times_.push_back(1e-3 * answer.processing_time);
  }

  void forgetAnswers() {
    stamps_.clear();
    ages_.clear();
    processing_times_.clear();
  }

  void publishOneAfterAnother() {
    for (int i = 0; i < 15; ++i) {
      const ros::Time stamp = publishNow();
      EXPECT_TRUE(waitUntil([&] { return !stamps_.empty() && stamps_.back() == stamp; }));
    }
  }

  // Idle: all images sent so far have been answered or dropped.
  int dropped() const {
    EXPECT_TRUE(diagnostics_.waitForReport());
    return static_cast<int>(diagnostics_.number("frames dropped"));
  }

  TestCamera camera_{"", 1000};  // itself it drops nothing
  Diagnostics diagnostics_;
  sensor_msgs::Image image_ =
      imageOfPlane(320, 240, "16UC1", Eigen::Vector3d(0.2, -0.4, -1.0).normalized(), 1.4);
  sensor_msgs::CameraInfo info_ = testInfo(320, 240);
  int published_ = 0, answered_ = 0;
  std::vector<ros::Time> stamps_;
  std::vector<double> ages_;              // [s] of answers
  std::vector<double> processing_times_;  // [s]
  ros::NodeHandle nh_;
  ros::Subscriber planes_ = nh_.subscribe<PlaneArray>(
      "plane_segmenter/planes", 1000, [this](const PlaneArray::ConstPtr& answer) { take(*answer); });
};

TEST_F(Overload, newestFirstAndTheRestCounted) {
  ASSERT_TRUE(waitUntil([this] {
    publishNow();
    spinFor(0.1);
    return !stamps_.empty();
  }));
  const int process = processThatPublishes("/plane_segmenter/planes");
  publishOneAfterAnother();
  const double pause = median(processing_times_) / 3.0;
  const int dropped_before = dropped();
  published_ = answered_ = 0;

  const auto publish_for = [&](double seconds) {
    const double end = now() + seconds;
    int published = 0;
    for (double next = now(); next < end; next += pause, ++published) {
      publishNow();
      spinFor(next + pause - now());
    }
    return published;
  };
  publish_for(1.5);
  constexpr double kSeconds = 3.0;
  const double memory = residentMegabytes(process);
  forgetAnswers();
  const int published = publish_for(kSeconds);

  ASSERT_GT(stamps_.size(), 10U);
  EXPECT_LT(static_cast<int>(stamps_.size()), published * 3 / 4) << "that was no overload";
  EXPECT_TRUE(std::is_sorted(stamps_.begin(), stamps_.end()));
  const double interval = kSeconds / static_cast<double>(stamps_.size());
  RecordProperty("interval_ms", static_cast<int>(1e3 * interval));
  RecordProperty("age_ms", static_cast<int>(1e3 * median(ages_)));
  // Some wait in sockets, far fewer than the segmenter's queue could hold.
  EXPECT_LT(median(ages_), 0.5 * kQueueSize * interval);
  EXPECT_GT(memory, 10.0);
  EXPECT_LT(residentMegabytes(process), memory + 20.0);

  EXPECT_TRUE(diagnostics_.waitForStatus(DiagnosticStatus::OK, "segmenting"));
  const int dropped_by_then = dropped();
  EXPECT_GT(dropped_by_then - dropped_before, 10);
  publishOneAfterAnother();
  EXPECT_EQ(dropped_by_then, dropped()) << "it still drops";
  EXPECT_EQ(published_, answered_ + dropped_by_then - dropped_before);
}

}  // namespace
}  // namespace line_plane_segmentation
