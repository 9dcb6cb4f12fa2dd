// SPDX-License-Identifier: BSD-3-Clause
#include "frame_worker.h"

#include <exception>
#include <utility>

namespace line_plane_segmentation {

FrameWorker::FrameWorker(std::size_t queue_size, Process process, Failed failed)
    : process_(std::move(process)),
      failed_(std::move(failed)),
      queue_(queue_size),
      thread_([this] { run(); }) {}

FrameWorker::~FrameWorker() {
  queue_.close();
  thread_.join();
}

void FrameWorker::run() {
  InputFrame frame;
  while (queue_.pop(frame)) {
    processSafely(frame);
    // Releases the messages before waiting for the next frame: their publisher may wait for that.
    frame = InputFrame{};
  }
}

void FrameWorker::processSafely(const InputFrame& frame) {
  try {
    process_(frame);
  } catch (const std::exception& exception) {
    reportFailure(exception.what());
  } catch (...) {
    reportFailure("an exception of unknown type");
  }
}

void FrameWorker::reportFailure(const char* problem) noexcept {
  try {
    failed_(problem);
  } catch (...) {
    // Out of memory, even reporting can fail. The next frame may find memory again.
    return;
  }
}

}  // namespace line_plane_segmentation
