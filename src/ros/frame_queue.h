// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>

#include "stamp_pairing.h"

namespace line_plane_segmentation {

/// Frames on their way from the subscription, which must never wait, to the thread that segments them.
///
/// Normally they wait in order, so that a short delay costs none. When the queue overflows the input is
/// faster than the processing: from then on only the newest waits and those before it are dropped and
/// counted, until the processing has caught up. So the delay stays below one frame's processing.
class FrameQueue {
 public:
  /// @param capacity  frames that wait at most; at least 1
  explicit FrameQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Never blocks for longer than pop() takes to move a frame out. Notes when the frame arrived.
  void push(CameraFrame frame);

  /// Waits for a frame.
  /// @return false once the queue is closed
  bool pop(CameraFrame& frame);

  /// Forgets the frames that wait, without counting them.
  void clear();

  /// Ends every pop(), now and later.
  void close();
  bool closed() const;

  /// Whether the next frame, or the one after it, would overflow the queue.
  bool nearlyFull() const;

  /// Frames dropped since the beginning.
  std::uint64_t dropped() const;

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<CameraFrame> frames_;
  bool overloaded_ = false;
  bool closed_ = false;
  std::uint64_t dropped_ = 0;
};

}  // namespace line_plane_segmentation
