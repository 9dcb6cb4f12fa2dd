// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <thread>

#include "frame_queue.h"

namespace line_plane_segmentation {

/// A queue of frames and the thread that works them off, one after another. Whatever is thrown at a frame
/// ends with that frame.
class FrameWorker {
 public:
  using Process = std::function<void(const CameraFrame&)>;
  using Failed = std::function<void(const std::string& problem)>;

  /// Starts the thread, which calls both functions.
  /// @param queue_size  frames that may wait
  /// @param process     called with every frame
  /// @param failed      called with what an exception says that left `process`; those of its own end here,
  /// too
  FrameWorker(std::size_t queue_size, Process process, Failed failed);

  /// Waits for the frame that is being processed.
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
