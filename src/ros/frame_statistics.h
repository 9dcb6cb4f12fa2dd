// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "image_validation.h"
#include "line_plane_segmentation/plane_segmenter.h"

namespace line_plane_segmentation {

/// Statistics of the frames of a time span, and counts since the start.
struct FrameReport {
  double seconds = 0.0;  ///< [s] length of the time span

  // For the time span:
  std::uint64_t frames = 0;       ///< number of processed frames
  double planes = 0.0;            ///< mean number per frame
  double published_planes = 0.0;  ///< mean number per frame of planes with a published orientation
  double valid_fraction = 0.0;    ///< mean fraction of pixels with a depth in range, 0 to 1
  double milliseconds = 0.0;      ///< [ms] mean per frame, segmentation and outputs
  double max_milliseconds = 0.0;  ///< [ms] slowest frame
  std::array<double, kStageCount> stage_milliseconds{};  ///< [ms] mean per frame
  double output_milliseconds = 0.0;  ///< [ms] mean per frame, building and publishing messages
  std::uint64_t delays = 0;          ///< number of frames with known delay
  double delay = 0.0;                ///< [s] mean delay from timestamp to publishing
  double max_delay = 0.0;            ///< [s]

  // Since the start:
  std::uint64_t total_frames = 0;
  std::uint64_t total_failed = 0;
  std::array<std::uint64_t, kRefusalCount> total_refused{};
  std::uint64_t total_untracked = 0;  ///< number of planes beyond the tracker's limit per image

  Refusal last_refusal = Refusal::kNone;  ///< reason for refusing the last frame, kNone if it was processed
  std::string last_problem;               ///< reason why the last frame was not processed; empty if it was
  std::string frame_id;                   ///< frame of the last image
};

/// Returns the time from `stamp` to `now` [s]. Empty if one of them is 0, or if they differ by more than an
/// hour and are therefore of different clocks, for example for a bag played without its clock.
std::optional<double> delayOf(const ros::Time& stamp, const ros::Time& now);

/// Counts frames. Written by the processing thread, read by the reporting thread.
class FrameStatistics {
 public:
  /// Counts a processed frame.
  /// @param published_planes     number of published planes
  /// @param output_milliseconds  [ms] time for building and publishing messages
  /// @param delay                [s] from timestamp to publishing; empty if unknown
  void processed(const Segmentation& segmentation, std::size_t published_planes, const StageClock& clock,
                 double output_milliseconds, const std::string& frame_id, const std::optional<double>& delay);
  /// Counts a refused frame.
  void refused(Refusal refusal, const std::string& explanation, const std::string& frame_id);
  /// Counts a frame whose processing threw an exception.
  void failed(const std::string& problem);

  /// Adds the number of planes of a frame that have no lasting id.
  void untracked(std::size_t planes);

  /// Returns the report of the time since the last call, and starts the next time span.
  FrameReport take();

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;
  FrameReport sums_;  // sums of the time span; take() divides them into means
  Clock::time_point since_ = Clock::now();
};

}  // namespace line_plane_segmentation
