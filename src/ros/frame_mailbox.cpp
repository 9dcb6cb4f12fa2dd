// SPDX-License-Identifier: BSD-3-Clause
#include "frame_mailbox.h"

#include <exception>
#include <utility>

namespace line_plane_segmentation {

FrameMailbox::FrameMailbox(std::size_t capacity, Process process, Failed failed)
    : capacity_(capacity),
      process_(std::move(process)),
      failed_(std::move(failed)),
      thread_([this] { run(); }) {}

FrameMailbox::~FrameMailbox() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void FrameMailbox::push(InputFrame frame) {
  frame.arrived = std::chrono::steady_clock::now();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (frames_.size() >= capacity_) is_overloaded_ = true;
    if (is_overloaded_) {
      dropped_ += frames_.size();
      frames_.clear();
    }
    frames_.push_back(std::move(frame));
  }
  changed_.notify_one();
}

void FrameMailbox::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  frames_.clear();
}

bool FrameMailbox::isStopping() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_stopping_;
}

bool FrameMailbox::nearlyFull() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return frames_.size() + 1 >= capacity_;
}

std::uint64_t FrameMailbox::dropped() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return dropped_;
}

void FrameMailbox::run() {
  InputFrame frame;
  while (waitForFrame(frame)) {
    processSafely(frame);
    // Releases the messages before waiting for the next frame: their publisher may wait for that.
    frame = InputFrame{};
  }
}

// Returns false if the thread shall end.
bool FrameMailbox::waitForFrame(InputFrame& frame) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (frames_.empty()) is_overloaded_ = false;
  changed_.wait(lock, [this] { return is_stopping_ || !frames_.empty(); });
  if (is_stopping_) return false;
  frame = std::move(frames_.front());
  frames_.pop_front();
  return true;
}

void FrameMailbox::processSafely(const InputFrame& frame) {
  try {
    process_(frame);
  } catch (const std::exception& exception) {
    reportFailure(exception.what());
  } catch (...) {
    reportFailure("an exception of unknown type");
  }
}

void FrameMailbox::reportFailure(const char* problem) noexcept {
  try {
    failed_(problem);
  } catch (...) {
    // Out of memory, even reporting can fail. The next frame may find memory again.
    return;
  }
}

}  // namespace line_plane_segmentation
