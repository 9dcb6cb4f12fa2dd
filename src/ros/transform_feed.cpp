// SPDX-License-Identifier: BSD-3-Clause
#include "transform_feed.h"

namespace line_plane_segmentation {

void TransformFeed::setWanted(bool wanted) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wanted_ = wanted;
  update();
}

void TransformFeed::setNeeded(bool needed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  needed_ = needed;
  update();
}

void TransformFeed::update() {
  if ((wanted_ && needed_) == (listener_ != nullptr)) return;
  if (listener_) {
    listener_.reset();
    return;
  }
  // Between what is left from before and what comes now tf would interpolate.
  buffer_.clear();
  listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_, nh_);
}

}  // namespace line_plane_segmentation
