// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>

#include "line_plane_segmentation/plane_segmenter.h"

namespace line_plane_segmentation {

/// Measures the time of each stage of a frame [ms]. The time of a stage that did not run is 0.
class StageClock : public StageObserver {
 public:
  void frameStarted() override {
    milliseconds_.fill(0.0);
    start_ = last_ = Clock::now();
  }
  void stageFinished(Stage stage) override {
    const Clock::time_point now = Clock::now();
    milliseconds_[static_cast<std::size_t>(stage)] += Milliseconds(now - last_).count();
    last_ = now;
  }

  double milliseconds(Stage stage) const { return milliseconds_[static_cast<std::size_t>(stage)]; }

  /// Returns the time from the start of the frame to the end of its last stage [ms].
  double totalMilliseconds() const { return Milliseconds(last_ - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::duration<double, std::milli>;

  std::array<double, kStageCount> milliseconds_{};
  Clock::time_point start_{};
  Clock::time_point last_{};
};

}  // namespace line_plane_segmentation
