// SPDX-License-Identifier: BSD-3-Clause
#include "stamp_pairing.h"

#include <algorithm>

namespace line_plane_segmentation {
namespace {

// Takes the first message with this stamp out of the waiting ones; null if there is none.
template <typename MessagePtr>
MessagePtr take(std::deque<MessagePtr>& waiting, const ros::Time& stamp) {
  const auto found = std::find_if(waiting.begin(), waiting.end(),
                                  [&](const MessagePtr& message) { return message->header.stamp == stamp; });
  if (found == waiting.end()) return {};
  MessagePtr message = *found;
  waiting.erase(found);
  return message;
}

}  // namespace

bool StampPairing::add(const sensor_msgs::ImageConstPtr& image, CameraFrame& frame) {
  const auto info = take(infos_, image->header.stamp);
  if (!info) {
    images_.push_back(image);
    if (images_.size() <= max_images_) return false;
    ++lost_images_;
    lost_stamps_.push_back(images_.front()->header.stamp);
    if (lost_stamps_.size() > kMaxInfos) lost_stamps_.pop_front();
    images_.pop_front();
    return false;
  }
  frame = {image, info};
  return true;
}

bool StampPairing::add(const sensor_msgs::CameraInfoConstPtr& info, CameraFrame& frame) {
  const auto image = take(images_, info->header.stamp);
  if (!image) {
    const auto lost = std::find(lost_stamps_.begin(), lost_stamps_.end(), info->header.stamp);
    if (lost != lost_stamps_.end()) {
      ++late_infos_;
      lost_stamps_.erase(lost);
    }
    infos_.push_back(info);
    if (infos_.size() > kMaxInfos) infos_.pop_front();
    return false;
  }
  frame = {image, info};
  return true;
}

void StampPairing::clear() {
  images_.clear();
  infos_.clear();
  lost_stamps_.clear();
}

}  // namespace line_plane_segmentation
