// SPDX-License-Identifier: BSD-3-Clause
#include "frame_queue.h"

#include <utility>

namespace line_plane_segmentation {

void FrameQueue::push(InputFrame frame) {
  frame.arrived = std::chrono::steady_clock::now();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (frames_.size() >= capacity_) overloaded_ = true;
    if (overloaded_) {
      dropped_ += frames_.size();
      frames_.clear();
    }
    frames_.push_back(std::move(frame));
  }
  changed_.notify_one();
}

bool FrameQueue::pop(InputFrame& frame) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (frames_.empty()) overloaded_ = false;
  changed_.wait(lock, [this] { return closed_ || !frames_.empty(); });
  if (closed_) return false;
  frame = std::move(frames_.front());
  frames_.pop_front();
  return true;
}

void FrameQueue::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  frames_.clear();
}

void FrameQueue::close() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

bool FrameQueue::closed() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return closed_;
}

bool FrameQueue::nearlyFull() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return frames_.size() + 1 >= capacity_;
}

std::uint64_t FrameQueue::dropped() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return dropped_;
}

}  // namespace line_plane_segmentation
