// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>

namespace line_plane_segmentation {

/// Time that the current frame has been processed so far. Written by one thread, read by any.
class ProcessingTime {
 public:
  using Clock = std::chrono::steady_clock;

  /// Counts the time while this exists.
  class Frame {
   public:
    explicit Frame(ProcessingTime& time) : time_(time) { time_.started_ = Clock::now().time_since_epoch(); }
    ~Frame() { time_.started_ = Clock::duration::zero(); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

   private:
    ProcessingTime& time_;
  };

  /// Returns the time of the current frame; 0 between frames.
  Clock::duration elapsed() const {
    const Clock::duration started = started_;
    return started == Clock::duration::zero() ? started : Clock::now().time_since_epoch() - started;
  }

 private:
  std::atomic<Clock::duration> started_{Clock::duration::zero()};  // since the clock's epoch
};

}  // namespace line_plane_segmentation
