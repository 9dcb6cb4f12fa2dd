// SPDX-License-Identifier: BSD-3-Clause
#include "frame_statistics.h"

#include <algorithm>

namespace line_plane_segmentation {

void FrameStatistics::processed(const Segmentation& segmentation, const StageClock& clock,
                                double output_milliseconds, const std::string& frame_id) {
  const double pixels = std::max(1.0, static_cast<double>(segmentation.labels.size()));
  const double milliseconds = clock.totalMilliseconds() + output_milliseconds;

  const std::lock_guard<std::mutex> lock(mutex_);
  ++sums_.frames;
  ++sums_.total_frames;
  sums_.planes += static_cast<double>(segmentation.planes.size());
  sums_.valid_share += segmentation.valid_pixels / pixels;
  sums_.milliseconds += milliseconds;
  sums_.max_milliseconds = std::max(sums_.max_milliseconds, milliseconds);
  for (int i = 0; i < kStageCount; ++i) {
    sums_.stage_milliseconds[static_cast<std::size_t>(i)] += clock.milliseconds(static_cast<Stage>(i));
  }
  sums_.output_milliseconds += output_milliseconds;
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

FrameReport FrameStatistics::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  FrameReport report = sums_;
  const Clock::time_point now = Clock::now();
  report.seconds = std::chrono::duration<double>(now - since_).count();
  since_ = now;

  const double frames = std::max(1.0, static_cast<double>(report.frames));
  report.planes /= frames;
  report.valid_share /= frames;
  report.milliseconds /= frames;
  for (double& stage : report.stage_milliseconds) stage /= frames;
  report.output_milliseconds /= frames;

  sums_.frames = 0;
  sums_.planes = sums_.valid_share = 0.0;
  sums_.milliseconds = sums_.max_milliseconds = sums_.output_milliseconds = 0.0;
  sums_.stage_milliseconds.fill(0.0);
  return report;
}

}  // namespace line_plane_segmentation
