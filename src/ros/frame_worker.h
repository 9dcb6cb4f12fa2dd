// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <thread>

#include "frame_queue.h"

namespace line_plane_segmentation {

/// Queue of frames, and a thread that processes them one by one. After an exception the next frame is
/// processed.
class FrameWorker {
 public:
  using Process = std::function<void(const InputFrame&)>;
  using Failed = std::function<void(const std::string& problem)>;

  /// Starts the thread, which calls both functions.
  /// @param queue_size  largest number of waiting frames
  /// @param process  called with each frame
  /// @param failed   called with the message of an exception thrown by `process`; exceptions of `failed`
  /// itself
  ///         are caught and ignored
  FrameWorker(std::size_t queue_size, Process process, Failed failed);

  /// Waits until the current frame is processed, and ends the thread.
  ~FrameWorker();

  FrameWorker(const FrameWorker&) = delete;
  FrameWorker& operator=(const FrameWorker&) = delete;

  FrameQueue& queue() { return queue_; }
  const FrameQueue& queue() const { return queue_; }

 private:
  void run();
  void processSafely(const InputFrame& frame);
  void reportFailure(const char* problem) noexcept;

  const Process process_;
  const Failed failed_;
  FrameQueue queue_;
  std::thread thread_;
};

}  // namespace line_plane_segmentation
