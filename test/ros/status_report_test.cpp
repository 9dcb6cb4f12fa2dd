// SPDX-License-Identifier: BSD-3-Clause
#include "status_report.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>

namespace line_plane_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using std::chrono::milliseconds;
using std::chrono::seconds;

const InputTimes::TimePoint kNow = InputTimes::TimePoint{} + std::chrono::hours(1);

// An output has a subscriber, and frames arrive.
NodeletStatus statusOfWorkingNodelet() {
  NodeletStatus status;
  status.subscribed = true;
  status.topics.image = "/camera/depth/image_rect";
  status.topics.info = "/camera/depth/camera_info";
  status.input.subscribed = kNow - seconds(60);
  status.input.image = status.input.info = status.input.frame = kNow - milliseconds(30);
  status.frames.seconds = 2.0;
  status.frames.frames = status.frames.total_frames = 60;
  status.frames.planes = status.frames.published_planes = 4.0;
  status.frames.valid_fraction = 0.9;
  return status;
}

diagnostic_updater::DiagnosticStatusWrapper reportOf(const NodeletStatus& status) {
  diagnostic_updater::DiagnosticStatusWrapper diagnostics;
  report(status, kNow, diagnostics);
  return diagnostics;
}

std::string valueOf(const DiagnosticStatus& diagnostics, const std::string& key) {
  for (const auto& value : diagnostics.values) {
    if (value.key == key) return value.value;
  }
  return "no such key";
}

void expectStatus(const NodeletStatus& status, int level, const std::string& text) {
  const auto diagnostics = reportOf(status);
  EXPECT_EQ(level, static_cast<int>(diagnostics.level)) << diagnostics.message;
  EXPECT_NE(std::string::npos, diagnostics.message.find(text)) << diagnostics.message;
}

TEST(StatusReport, allIsWell) { expectStatus(statusOfWorkingNodelet(), DiagnosticStatus::OK, "segmenting"); }

TEST(StatusReport, nobodySubscribes) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.subscribed = false;
  status.input = InputTimes{};
  expectStatus(status, DiagnosticStatus::OK, "nobody subscribes to my outputs");
}

TEST(StatusReport, doesNotStart) {
  NodeletStatus status;
  status.failure = "~queue_size must be a whole number from 1 to 1000";
  expectStatus(status, DiagnosticStatus::ERROR, "~queue_size");
}

TEST(StatusReport, waitsForImages) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.input = InputTimes{};
  status.input.subscribed = kNow - seconds(3);
  expectStatus(status, DiagnosticStatus::OK, "waiting for images on /camera/depth/image_rect");
  status.input.subscribed = kNow - seconds(10);
  expectStatus(status, DiagnosticStatus::WARN, "waiting for images on /camera/depth/image_rect");
}

TEST(StatusReport, waitsForClouds) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.topics = {"", "", "/camera/depth_registered/points"};
  status.input.image = status.input.info = InputTimes::TimePoint{};
  expectStatus(status, DiagnosticStatus::OK, "segmenting");
  EXPECT_EQ("/camera/depth_registered/points", valueOf(reportOf(status), "point cloud topic"));
  status.input.frame = kNow - seconds(11);
  expectStatus(status, DiagnosticStatus::WARN, "waiting for point clouds on /camera/depth_registered/points");
}

// Row 20.
TEST(StatusReport, waitsForCameraInfo) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.input.info = status.input.frame = InputTimes::TimePoint{};
  expectStatus(status, DiagnosticStatus::WARN, "waiting for camera_info on /camera/depth/camera_info");
  status.input.info = kNow - milliseconds(20);
  expectStatus(status, DiagnosticStatus::WARN,
               "camera_info on /camera/depth/camera_info with the stamp of an image");
}

TEST(StatusReport, inputEnds) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.input.image = status.input.info = status.input.frame = kNow - seconds(9);
  expectStatus(status, DiagnosticStatus::OK, "segmenting");
  status.input.image = status.input.info = status.input.frame = kNow - seconds(11);
  expectStatus(status, DiagnosticStatus::WARN, "waiting for images");
}

// A camera that was unplugged a moment ago.
TEST(StatusReport, inputPauses) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.frames = FrameReport{};
  expectStatus(status, DiagnosticStatus::OK, "segmenting");
  status.input.image = status.input.info = status.input.frame = kNow - seconds(3);
  expectStatus(status, DiagnosticStatus::OK,
               "no frame since the last report: waiting for images on /camera/depth/image_rect");
  status.input.image = kNow;
  expectStatus(status, DiagnosticStatus::OK,
               "no frame since the last report: waiting for camera_info on /camera/depth/camera_info");
}

TEST(StatusReport, filtersLeaveNothing) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.frames.published_planes = 0.0;
  expectStatus(status, DiagnosticStatus::OK, "all planes are left out of the outputs");
  EXPECT_EQ("4.00", valueOf(reportOf(status), "planes a frame"));
  EXPECT_EQ("0.00", valueOf(reportOf(status), "planes published a frame"));
}

TEST(StatusReport, imagesWithoutCameraInfo) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.lost = 7;
  expectStatus(status, DiagnosticStatus::OK, "segmenting");
  EXPECT_EQ("7", valueOf(reportOf(status), "images without camera_info"));
  status.newly_lost = 5;
  expectStatus(status, DiagnosticStatus::WARN,
               "5 images lost: no camera_info on /camera/depth/camera_info has their stamp");
  status.newly_late = 4;
  expectStatus(status, DiagnosticStatus::WARN, "Raise ~queue_size");
  status.input.frame = InputTimes::TimePoint{};
  expectStatus(status, DiagnosticStatus::WARN, "Raise ~queue_size");
}

TEST(StatusReport, refusals) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.frames.last_refusal = Refusal::kShortData;
  status.frames.last_problem = "too few bytes";
  status.frames.total_refused[static_cast<std::size_t>(Refusal::kShortData)] = 7;
  expectStatus(status, DiagnosticStatus::WARN, "short_data");
  expectStatus(status, DiagnosticStatus::WARN, "too few bytes");
  EXPECT_EQ("7", valueOf(reportOf(status), "frames refused: short_data"));
  EXPECT_EQ("0", valueOf(reportOf(status), "frames refused: encoding"));

  status.frames.last_refusal = Refusal::kNoIntrinsics;
  status.frames.last_problem = "calibrate the camera";
  expectStatus(status, DiagnosticStatus::ERROR, "calibrate");
}

TEST(StatusReport, planesThatAreNotTracked) {
  NodeletStatus status = statusOfWorkingNodelet();
  EXPECT_EQ("0", valueOf(reportOf(status), "planes not tracked"));
  FrameStatistics statistics;
  statistics.untracked(5);
  statistics.untracked(2);
  status.frames = statistics.take();
  EXPECT_EQ("7", valueOf(reportOf(status), "planes not tracked"));
}

TEST(StatusReport, failures) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.frames.last_problem = "std::bad_alloc";
  expectStatus(status, DiagnosticStatus::ERROR, "std::bad_alloc");
}

TEST(StatusReport, drops) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.dropped = 20;
  expectStatus(status, DiagnosticStatus::OK, "segmenting");
  EXPECT_EQ("20", valueOf(reportOf(status), "frames dropped"));
  status.newly_dropped = 5;
  expectStatus(status, DiagnosticStatus::WARN, "5 frames dropped");
}

// Row 10.
TEST(StatusReport, slowFrames) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.time_in_frame = seconds(12);
  status.input.frame = kNow - seconds(60);  // the frames behind it wait
  expectStatus(status, DiagnosticStatus::WARN, "the current frame has taken 12.0 s");

  status = statusOfWorkingNodelet();
  status.time_in_frame = milliseconds(500);
  expectStatus(status, DiagnosticStatus::OK, "segmenting");
  status.frames.max_milliseconds = 3200.0;
  expectStatus(status, DiagnosticStatus::WARN, "the slowest frame took 3.2 s");
}

TEST(StatusReport, noDepthAtAll) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.frames.valid_fraction = 0.0;
  expectStatus(status, DiagnosticStatus::WARN, "no pixel has a depth");
}

TEST(StatusReport, figures) {
  NodeletStatus status = statusOfWorkingNodelet();
  status.frames.stage_milliseconds[static_cast<std::size_t>(Stage::kExtraction)] = 3.25;
  const auto diagnostics = reportOf(status);
  EXPECT_EQ("30.00", valueOf(diagnostics, "rate [Hz]"));
  EXPECT_EQ("4.00", valueOf(diagnostics, "planes a frame"));
  EXPECT_EQ("90.0", valueOf(diagnostics, "pixels with depth [%]"));
  EXPECT_EQ("3.25", valueOf(diagnostics, "time of extraction [ms]"));
  for (int i = 0; i < kStageCount; ++i) {
    const std::string key = std::string("time of ") + nameOf(static_cast<Stage>(i)) + " [ms]";
    EXPECT_NE("no such key", valueOf(diagnostics, key)) << key;
  }
}

TEST(StatusReport, delay) {
  NodeletStatus status = statusOfWorkingNodelet();
  EXPECT_EQ("unknown: the stamps are not of this clock", valueOf(reportOf(status), "delay [ms]"));
  status.frames.delays = 60;
  status.frames.delay = 0.0123;
  status.frames.max_delay = 0.2;
  EXPECT_EQ("12.3", valueOf(reportOf(status), "delay [ms]"));
  EXPECT_EQ("200.0", valueOf(reportOf(status), "longest delay [ms]"));
  status.frames = FrameReport{};
  EXPECT_EQ("unknown", valueOf(reportOf(status), "delay [ms]"));
}

TEST(DelayOf, isKnownWithinOneClock) {
  EXPECT_NEAR(0.25, delayOf(ros::Time(1000.0), ros::Time(1000.25)).value(), 1e-6);
  EXPECT_NEAR(-0.5, delayOf(ros::Time(1000.5), ros::Time(1000.0)).value(), 1e-6) << "another machine's clock";
  EXPECT_FALSE(delayOf(ros::Time(0.0), ros::Time(1000.0)));
  EXPECT_FALSE(delayOf(ros::Time(1000.0), ros::Time(0.0))) << "simulated time has not begun";
  EXPECT_FALSE(delayOf(ros::Time(1000.0), ros::Time(1700000000.0))) << "a bag without its clock";
  EXPECT_FALSE(delayOf(ros::Time(4294967295.0), ros::Time(1000.0))) << "far future";
}

TEST(FrameStatistics, makesMeansOfTheTimeSinceTheLastReport) {
  FrameStatistics statistics;
  Segmentation segmentation;
  segmentation.labels.resize(10);
  segmentation.planes.resize(2);
  segmentation.valid_pixels = 5;
  const StageClock clock;
  statistics.processed(segmentation, 2, clock, 1.0, "camera", 0.5);
  segmentation.planes.resize(3);
  segmentation.valid_pixels = 10;
  statistics.processed(segmentation, 1, clock, 3.0, "camera", -0.1);
  statistics.processed(segmentation, 3, clock, 2.0, "camera", std::nullopt);
  statistics.refused(Refusal::kEncoding, "no depth image", "camera");

  FrameReport report = statistics.take();
  EXPECT_EQ(3U, report.frames);
  EXPECT_EQ(8.0 / 3.0, report.planes);
  EXPECT_EQ(2.0, report.published_planes);
  EXPECT_EQ(2.5 / 3.0, report.valid_fraction);
  EXPECT_EQ(2.0, report.milliseconds);
  EXPECT_EQ(3.0, report.max_milliseconds);
  EXPECT_EQ(2U, report.delays);
  EXPECT_DOUBLE_EQ(0.2, report.delay);
  EXPECT_EQ(0.5, report.max_delay);
  EXPECT_EQ(Refusal::kEncoding, report.last_refusal);
  EXPECT_EQ(1U, report.total_refused[static_cast<std::size_t>(Refusal::kEncoding)]);

  report = statistics.take();
  EXPECT_EQ(0U, report.frames);
  EXPECT_EQ(0.0, report.planes);
  EXPECT_EQ(3U, report.total_frames);
  EXPECT_EQ(0U, report.delays);
  EXPECT_EQ(0.0, report.max_delay);
}

}  // namespace
}  // namespace line_plane_segmentation
