// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "input_frame.h"

namespace line_plane_segmentation {

/// Hands frames from the subscription, which must never block, to a thread of its own that processes them one
/// by one. The public functions may be called from any thread.
///
/// Normally a FIFO queue, so that a short delay drops no frame. When it overflows, the input is faster than
/// the processing: from then on only the newest frame is kept, and older ones are dropped and counted,
/// until the processing has caught up. This bounds the latency to the processing time of one frame.
class FrameMailbox {
 public:
  using Process = std::function<void(const InputFrame&)>;
  using Failed = std::function<void(const std::string& problem)>;

  /// Starts the thread, which calls both functions.
  /// @param capacity  largest number of waiting frames, at least 1
  /// @param process   called with each frame; after an exception the next frame is processed
  /// @param failed    called with the message of an exception thrown by `process`; exceptions of `failed`
  ///                  itself are caught and ignored
  FrameMailbox(std::size_t capacity, Process process, Failed failed);

  /// Waits until the current frame is processed, and ends the thread. Waiting frames are not processed.
  ~FrameMailbox();

  FrameMailbox(const FrameMailbox&) = delete;
  FrameMailbox& operator=(const FrameMailbox&) = delete;

  /// Never blocks for longer than the thread needs to move a frame. Stores the time of arrival.
  void push(InputFrame frame);

  /// Removes the waiting frames without counting them as dropped.
  void clear();

  /// Returns true once the destructor waits for the current frame.
  bool isStopping() const;

  /// Returns true if one of the next two frames would overflow the mailbox.
  bool nearlyFull() const;

  /// Returns the number of frames dropped since construction.
  std::uint64_t dropped() const;

 private:
  void run();
  bool waitForFrame(InputFrame& frame);
  void processSafely(const InputFrame& frame);
  void reportFailure(const char* problem) noexcept;

  const std::size_t capacity_;
  const Process process_;
  const Failed failed_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<InputFrame> frames_;
  bool is_overloaded_ = false;
  bool is_stopping_ = false;
  std::uint64_t dropped_ = 0;

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace line_plane_segmentation
