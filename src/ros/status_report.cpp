// SPDX-License-Identifier: BSD-3-Clause
#include "status_report.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace line_plane_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using TimePoint = InputTimes::TimePoint;

constexpr std::chrono::seconds kPatience(10);      // time after which missing input is a warning
constexpr std::chrono::milliseconds kPause(1500);  // longer than the image period of any depth camera

constexpr std::chrono::seconds kSlow(2);  // time of a frame that is a warning

struct Summary {
  unsigned char level;
  std::string text;
};

double toSeconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

std::string lateInfos(const NodeletStatus& status) {
  return std::to_string(status.newly_late) + " images lost: camera_info on " + status.topics.info +
         " arrives more than queue_size images after its image. Raise ~queue_size";
}

std::string slowFrame(const char* state, double seconds) {
  char text[120];
  std::snprintf(text, sizeof(text), "%s %.1f s: larger scanline_spacing and min_plane_inliers take less time",
                state, seconds);
  return text;
}

// Returns which input is missing for the first or next frame.
std::string missingInput(const NodeletStatus& status, std::chrono::milliseconds patience, TimePoint now) {
  const auto recent = [&](TimePoint time) { return time != TimePoint{} && now - time < patience; };
  if (!status.topics.cloud.empty()) return "waiting for point clouds on " + status.topics.cloud;
  if (!recent(status.input.image)) return "waiting for images on " + status.topics.image;
  if (!recent(status.input.info)) return "waiting for camera_info on " + status.topics.info;
  if (status.newly_late > 0) return lateInfos(status);
  return "waiting for camera_info on " + status.topics.info + " with the stamp of an image on " +
         status.topics.image + ": none has one";
}

// State of a segmenter that receives frames and processes them without errors.
Summary summarizeFrames(const NodeletStatus& status, TimePoint now) {
  const FrameReport& frames = status.frames;
  if (status.newly_dropped > 0) {
    return {DiagnosticStatus::WARN,
            "input is faster than processing: " + std::to_string(status.newly_dropped) + " frames dropped"};
  }
  if (frames.max_milliseconds >= 1000.0 * toSeconds(kSlow)) {
    return {DiagnosticStatus::WARN, slowFrame("the slowest frame took", frames.max_milliseconds / 1000.0)};
  }
  if (status.newly_late > 0) return {DiagnosticStatus::WARN, lateInfos(status)};
  if (status.newly_lost > 0) {
    return {DiagnosticStatus::WARN, std::to_string(status.newly_lost) + " images lost: no camera_info on " +
                                        status.topics.info + " has their stamp"};
  }
  if (frames.frames == 0 && now - status.input.frame >= kPause) {
    return {DiagnosticStatus::OK,
            "segmenting, but no frame since the last report: " + missingInput(status, kPause, now)};
  }
  if (frames.frames > 0 && frames.valid_fraction == 0.0) {
    return {DiagnosticStatus::WARN, "no pixel has a depth within min_range and max_range"};
  }
  if (frames.planes > 0.0 && frames.published_planes == 0.0) {
    return {DiagnosticStatus::OK,
            "segmenting, but all planes are left out of the outputs: see publish_horizontal_up "
            "and its like, and gravity_frame"};
  }
  return {DiagnosticStatus::OK, "segmenting"};
}

Summary summarize(const NodeletStatus& status, TimePoint now) {
  if (!status.failure.empty()) return {DiagnosticStatus::ERROR, status.failure};
  if (!status.subscribed) return {DiagnosticStatus::OK, "nobody subscribes to my outputs: idle"};

  if (status.time_in_frame >= kSlow) {
    return {DiagnosticStatus::WARN,
            slowFrame("the current frame has taken", toSeconds(status.time_in_frame))};
  }
  const TimePoint alive = std::max(status.input.subscribed, status.input.frame);
  const bool late = now - alive >= kPatience;
  if (late || status.input.frame == TimePoint{}) {
    const std::uint8_t level = late ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
    return {level, missingInput(status, kPatience, now)};
  }

  const FrameReport& frames = status.frames;
  if (frames.last_refusal != Refusal::kNone) {
    const bool hopeless = frames.last_refusal == Refusal::kNoIntrinsics;
    const std::uint8_t level = hopeless ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN;
    return {level, std::string("refused (") + nameOf(frames.last_refusal) + "): " + frames.last_problem};
  }
  if (!frames.last_problem.empty()) {
    return {DiagnosticStatus::ERROR, "processing failed: " + frames.last_problem};
  }
  return summarizeFrames(status, now);
}

void addInputs(const NodeletStatus& status, diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  if (status.topics.cloud.empty()) {
    diagnostics.add("image topic", status.topics.image);
    diagnostics.add("camera_info topic", status.topics.info);
    diagnostics.add("camera_info", status.input.has_fallen_back ? "the newest: none has the stamp of an image"
                                                                : "that of the image's stamp");
  } else {
    diagnostics.add("point cloud topic", status.topics.cloud);
  }
}

}  // namespace

void report(const NodeletStatus& status, TimePoint now,
            diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  const Summary summary = summarize(status, now);
  diagnostics.summary(summary.level, summary.text);

  const FrameReport& frames = status.frames;
  const double seconds = std::max(frames.seconds, 1e-6);
  addInputs(status, diagnostics);
  diagnostics.addf("rate [Hz]", "%.2f", static_cast<double>(frames.frames) / seconds);
  if (frames.delays > 0) {
    diagnostics.addf("delay [ms]", "%.1f", 1000.0 * frames.delay);
    diagnostics.addf("longest delay [ms]", "%.1f", 1000.0 * frames.max_delay);
  } else {
    const char* unknown = frames.frames > 0 ? "unknown: the stamps are not of this clock" : "unknown";
    diagnostics.add("delay [ms]", unknown);
    diagnostics.add("longest delay [ms]", unknown);
  }
  diagnostics.add("frames processed", frames.total_frames);
  diagnostics.add("frames dropped", status.dropped);
  diagnostics.add("frames failed", frames.total_failed);
  diagnostics.add("images without camera_info", status.lost);
  for (std::size_t i = 1; i < kRefusalCount; ++i) {
    diagnostics.add(std::string("frames refused: ") + nameOf(static_cast<Refusal>(i)),
                    frames.total_refused[i]);
  }
  diagnostics.add("planes not tracked", frames.total_untracked);
  diagnostics.addf("planes a frame", "%.2f", frames.planes);
  diagnostics.addf("planes published a frame", "%.2f", frames.published_planes);
  diagnostics.addf("pixels with depth [%]", "%.1f", 100.0 * frames.valid_fraction);
  diagnostics.addf("time a frame [ms]", "%.2f", frames.milliseconds);
  diagnostics.addf("time of the slowest frame [ms]", "%.2f", frames.max_milliseconds);
  for (int i = 0; i < kStageCount; ++i) {
    diagnostics.addf(std::string("time of ") + nameOf(static_cast<Stage>(i)) + " [ms]", "%.2f",
                     frames.stage_milliseconds[i]);
  }
  diagnostics.addf("time of outputs [ms]", "%.2f", frames.output_milliseconds);
}

}  // namespace line_plane_segmentation
