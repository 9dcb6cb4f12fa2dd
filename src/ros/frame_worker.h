// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <thread>

#include "frame_queue.h"

namespace line_plane_segmentation {

/// Queue of frames, and the thread that processes them one after another. An exception ends the processing
/// of its frame only.
class FrameWorker {
 public:
  using Process = std::function<void(const CameraFrame&)>;
  using Failed = std::function<void(const std::string& problem)>;

  /// Starts the thread that calls both functions.
  /// @param queue_size  largest number of waiting frames
  /// @param process  called with each frame
  /// @param failed  called with the message of an exception thrown by `process`; its own exceptions are
  ///         caught as well
  FrameWorker(std::size_t queue_size, Process process, Failed failed);

  /// Waits until the current frame is processed.
  ~FrameWorker();

  FrameWorker(const FrameWorker&) = delete;
  FrameWorker& operator=(const FrameWorker&) = delete;

  FrameQueue& queue() { return queue_; }
  const FrameQueue& queue() const { return queue_; }

 private:
  void run();
  void work(const CameraFrame& frame);
  void tell(const char* problem) noexcept;

  const Process process_;
  const Failed failed_;
  FrameQueue queue_;
  std::thread thread_;
};

}  // namespace line_plane_segmentation
