// SPDX-License-Identifier: BSD-3-Clause
#include "transform_listener.h"

namespace line_plane_segmentation {

void TransformListener::setNeeded(bool needed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (needed == (listener_ != nullptr)) return;
  listener_.reset();
  if (!needed) return;
  // tf would interpolate between old transforms and new ones.
  buffer_.clear();
  started_ = std::chrono::steady_clock::now();
  listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_, nh_);
}

bool TransformListener::isNew() const {
  constexpr std::chrono::seconds kConnecting(1);
  const std::lock_guard<std::mutex> lock(mutex_);
  return listener_ && std::chrono::steady_clock::now() - started_ < kConnecting;
}

}  // namespace line_plane_segmentation
