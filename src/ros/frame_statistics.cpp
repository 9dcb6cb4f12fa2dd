// SPDX-License-Identifier: BSD-3-Clause
#include "frame_statistics.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {

std::optional<double> delayOf(const ros::Time& stamp, const ros::Time& now) {
  constexpr double kLongest = 3600.0;  // [s]
  if (stamp.isZero() || now.isZero()) return {};
  // ros::Time::operator- throws if the difference is too large.
  const double delay = now.toSec() - stamp.toSec();
  if (std::abs(delay) > kLongest) return {};
  return delay;
}

void FrameStatistics::processed(const Segmentation& segmentation, std::size_t published_planes,
                                const StageClock& clock, double output_milliseconds,
                                const std::string& frame_id, const std::optional<double>& delay) {
  const double pixels = std::max(1.0, static_cast<double>(segmentation.labels.size()));
  const double milliseconds = clock.totalMilliseconds() + output_milliseconds;

  const std::lock_guard<std::mutex> lock(mutex_);
  ++sums_.frames;
  ++sums_.total_frames;
  sums_.planes += static_cast<double>(segmentation.planes.size());
  sums_.published_planes += static_cast<double>(published_planes);
  sums_.valid_fraction += segmentation.valid_pixels / pixels;
  sums_.milliseconds += milliseconds;
  sums_.max_milliseconds = std::max(sums_.max_milliseconds, milliseconds);
  for (int i = 0; i < kStageCount; ++i) {
    sums_.stage_milliseconds[i] += clock.milliseconds(static_cast<Stage>(i));
  }
  sums_.output_milliseconds += output_milliseconds;
  if (delay) {
    sums_.max_delay = sums_.delays == 0 ? *delay : std::max(sums_.max_delay, *delay);
    sums_.delay += *delay;
    ++sums_.delays;
  }
  sums_.last_refusal = Refusal::kNone;
  sums_.last_problem.clear();
  sums_.frame_id = frame_id;
}

void FrameStatistics::refused(Refusal refusal, const std::string& explanation, const std::string& frame_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++sums_.total_refused[static_cast<std::size_t>(refusal)];
  sums_.last_refusal = refusal;
  sums_.last_problem = explanation;
  sums_.frame_id = frame_id;
}

void FrameStatistics::failed(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++sums_.total_failed;
  sums_.last_refusal = Refusal::kNone;
  sums_.last_problem = problem;
}

void FrameStatistics::untracked(std::size_t planes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  sums_.total_untracked += planes;
}

FrameReport FrameStatistics::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  FrameReport report = sums_;
  const Clock::time_point now = Clock::now();
  report.seconds = std::chrono::duration<double>(now - since_).count();
  since_ = now;

  const double frames = std::max(1.0, static_cast<double>(report.frames));
  report.planes /= frames;
  report.published_planes /= frames;
  report.valid_fraction /= frames;
  report.milliseconds /= frames;
  for (double& stage : report.stage_milliseconds) stage /= frames;
  report.output_milliseconds /= frames;
  report.delay /= std::max(1.0, static_cast<double>(report.delays));

  sums_.frames = 0;
  sums_.planes = sums_.published_planes = sums_.valid_fraction = 0.0;
  sums_.milliseconds = sums_.max_milliseconds = sums_.output_milliseconds = 0.0;
  sums_.stage_milliseconds.fill(0.0);
  sums_.delays = 0;
  sums_.delay = sums_.max_delay = 0.0;
  return report;
}

}  // namespace line_plane_segmentation
