// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>

#include "input_frame.h"

namespace line_plane_segmentation {

/// Queue of frames from the subscription, which must never block, to the thread that segments them.
///
/// Normally a FIFO queue, so that a short delay drops no frame. When it overflows, the input is faster than
/// the processing: from then on only the newest frame is kept, and older ones are dropped and counted,
/// until the processing has caught up. This bounds the latency to the processing time of one frame.
class FrameQueue {
 public:
  /// @param capacity  largest number of waiting frames, at least 1
  explicit FrameQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Never blocks for longer than pop() needs to move a frame. Stores the time of arrival.
  void push(InputFrame frame);

  /// Waits for a frame.
  /// @return false once the queue is closed
  bool pop(InputFrame& frame);

  /// Removes the waiting frames without counting them as dropped.
  void clear();

  /// Makes the current and all later calls of pop() return false.
  void close();
  bool closed() const;

  /// Returns true if one of the next two frames would overflow the queue.
  bool nearlyFull() const;

  /// Returns the number of frames dropped since construction.
  std::uint64_t dropped() const;

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<InputFrame> frames_;
  bool overloaded_ = false;
  bool closed_ = false;
  std::uint64_t dropped_ = 0;
};

}  // namespace line_plane_segmentation
