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

template <typename MessagePtr>
void wait(std::deque<MessagePtr>& waiting, const MessagePtr& message, std::size_t capacity) {
  waiting.push_back(message);
  if (waiting.size() > capacity) waiting.pop_front();
}

}  // namespace

bool StampPairing::add(const sensor_msgs::ImageConstPtr& image, CameraFrame& frame) {
  const auto info = take(infos_, image->header.stamp);
  if (!info) {
    wait(images_, image, capacity_);
    return false;
  }
  frame = {image, info};
  return true;
}

bool StampPairing::add(const sensor_msgs::CameraInfoConstPtr& info, CameraFrame& frame) {
  const auto image = take(images_, info->header.stamp);
  if (!image) {
    wait(infos_, info, capacity_);
    return false;
  }
  frame = {image, info};
  return true;
}

void StampPairing::clear() {
  images_.clear();
  infos_.clear();
}

}  // namespace line_plane_segmentation
