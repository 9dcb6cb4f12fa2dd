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

#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/ros/image_validation.h"
#include "line_plane_segmentation/stage_clock.h"

namespace line_plane_segmentation {

/// How the frames of some span of time went, and all counts since the beginning.
struct FrameReport {
  double seconds = 0.0;  ///< [s] length of the span

  // Of the span:
  std::uint64_t frames = 0;       ///< processed
  double planes = 0.0;            ///< a frame
  double published_planes = 0.0;  ///< a frame, those with an orientation that is published
  double valid_share = 0.0;       ///< pixels with a depth in range, 0 to 1
  double milliseconds = 0.0;      ///< [ms] a frame, segmentation and outputs
  double max_milliseconds = 0.0;  ///< [ms] the slowest frame
  std::array<double, kStageCount> stage_milliseconds{};  ///< [ms] a frame
  double output_milliseconds = 0.0;                      ///< [ms] a frame, making and publishing messages
  std::uint64_t delays = 0;                              ///< frames whose delay is known
  double delay = 0.0;                                    ///< [s] a frame, from its stamp to its publishing
  double max_delay = 0.0;                                ///< [s]

  // Since the beginning:
  std::uint64_t total_frames = 0;
  std::uint64_t total_failed = 0;
  std::array<std::uint64_t, kRefusalCount> total_refused{};
  std::uint64_t total_untracked = 0;  ///< planes beyond those that the tracker takes of one image

  Refusal last_refusal = Refusal::kNone;  ///< kNone if the last frame was processed
  std::string last_problem;               ///< why the last frame was not processed; empty if it was
  std::string frame_id;                   ///< of the last frame
};

/// The time since a stamp [s]; unknown if one of the two is not set, or if they are not of one clock: a bag
/// that is played without its clock, or a camera that counts from its start.
std::optional<double> delayOf(const ros::Time& stamp, const ros::Time& now);

/// Counts frames: written by the thread that processes, read by the one that reports.
class FrameStatistics {
 public:
  /// @param published_planes  number of the segmentation's planes that were published
  void processed(const Segmentation& segmentation, std::size_t published_planes, const StageClock& clock,
                 double output_milliseconds, const std::string& frame_id, const std::optional<double>& delay);
  void refused(Refusal refusal, const std::string& explanation, const std::string& frame_id);
  void failed(const std::string& problem);

  /// Counts planes of a frame that have no lasting id.
  void untracked(std::size_t planes);

  /// The report about the time since the last call of this.
  FrameReport take();

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;
  FrameReport sums_;  // sums of the span, until take() makes means of them
  Clock::time_point since_ = Clock::now();
};

}  // namespace line_plane_segmentation
