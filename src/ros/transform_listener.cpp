// SPDX-License-Identifier: BSD-3-Clause
#include "transform_listener.h"

#include <tf2/exceptions.h>

namespace line_plane_segmentation {

void TransformListener::setNeeded(bool needed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (needed == (listener_ != nullptr)) return;
  listener_.reset();
  jump_subscriber_.shutdown();
  jump_detector_ = {};
  if (!needed) return;
  // tf would interpolate between old transforms and new ones.
  buffer_.clear();
  started_ = std::chrono::steady_clock::now();
  listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_, nh_);
  jump_subscriber_ = nh_.subscribe("/tf", 100, &TransformListener::onTransforms, this);
}

void TransformListener::onTransforms(const tf2_msgs::TFMessage& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  bool went_back = false;
  for (const auto& transform : message.transforms)
    went_back |= jump_detector_.jumpedBack(transform.child_frame_id, transform.header.stamp);
  if (!went_back) return;
  buffer_.clear();
  // The listener's own thread may have offered them to the full buffer.
  for (const auto& transform : message.transforms) {
    try {
      buffer_.setTransform(transform, "tf");
    } catch (const tf2::TransformException&) {  // as malformed as it was for the listener
    }
  }
}

bool TransformListener::isConnecting() const {
  constexpr std::chrono::seconds kConnecting(1);
  const std::lock_guard<std::mutex> lock(mutex_);
  return listener_ && std::chrono::steady_clock::now() - started_ < kConnecting;
}

}  // namespace line_plane_segmentation
