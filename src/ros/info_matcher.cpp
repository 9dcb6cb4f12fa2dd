// SPDX-License-Identifier: BSD-3-Clause
#include "info_matcher.h"

#include <algorithm>
#include <array>
#include <utility>

namespace line_plane_segmentation {
namespace {

constexpr std::array<const char*, 3> kNames = {"exact", "latest", "auto"};

InputFrame frameOf(const DepthMessage& message, const sensor_msgs::CameraInfoConstPtr& info) {
  InputFrame frame;
  frame.image = message.image;
  frame.info = info;
  frame.compressed = message.compressed;
  return frame;
}

}  // namespace

const char* nameOf(InfoMatching matching) { return kNames[static_cast<std::size_t>(matching)]; }

std::optional<InfoMatching> infoMatchingOf(const std::string& name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return {};
  return static_cast<InfoMatching>(found - kNames.begin());
}

void InfoMatcher::addImage(const DepthMessage& image, const InfoHistory& infos, TimePoint now,
                           Frames& frames) {
  ++images_;
  if (matching_ != InfoMatching::kLatest) {
    if (const auto info = infos.find(image.image->header.stamp)) {
      recordExactMatch(images_);
      frames.push_back(frameOf(image, info));
      return;
    }
  }
  waiting_.push_back({image, images_});
  if (!unpaired_since_) unpaired_since_ = now;
  if (matching_ == InfoMatching::kLatest || has_fallen_back_) {
    matchNewest(infos, frames);
  } else if (mustFallBack(now)) {
    fallBack(infos, frames);
  }
  if (waiting_.size() <= capacity_) return;
  discard(waiting_.front());
  waiting_.pop_front();
}

void InfoMatcher::addInfo(const ros::Time& stamp, const InfoHistory& infos, Frames& frames) {
  if (matching_ != InfoMatching::kLatest) {
    const auto info = infos.find(stamp);
    for (auto image = waiting_.begin(); image != waiting_.end();) {
      if (image->message.image->header.stamp != stamp) {
        ++image;
        continue;
      }
      frames.push_back(frameOf(image->message, info));
      recordExactMatch(image->number);
      image = waiting_.erase(image);
    }
    // The camera_info comes after its image, which has gone with another: from the next image on it is waited
    // for.
    const auto approximate =
        std::find_if(approximate_matches_.begin(), approximate_matches_.end(),
                     [&stamp](const ApproximateMatch& image) { return image.stamp == stamp; });
    if (approximate != approximate_matches_.end()) recordExactMatch(approximate->number);
  }
  if (matching_ == InfoMatching::kLatest || has_fallen_back_) matchNewest(infos, frames);
  const auto lost = std::find(lost_stamps_.begin(), lost_stamps_.end(), stamp);
  if (lost == lost_stamps_.end()) return;
  ++late_infos_;
  lost_stamps_.erase(lost);
}

void InfoMatcher::matchWaiting(const InfoHistory& infos, Frames& frames) {
  std::deque<Waiting> images;
  images.swap(waiting_);
  for (const Waiting& image : images) {
    const auto info = infos.find(image.message.image->header.stamp);
    if (info) {
      frames.push_back(frameOf(image.message, info));
      recordExactMatch(image.number);
    } else {
      waiting_.push_back(image);
    }
  }
}

void InfoMatcher::poll(const InfoHistory& infos, TimePoint now, Frames& frames) {
  if (!waiting_.empty() && !has_fallen_back_ && mustFallBack(now)) fallBack(infos, frames);
}

void InfoMatcher::finish(const InfoHistory& infos, Frames& frames) {
  if (matching_ == InfoMatching::kAuto) fallBack(infos, frames);
  for (const Waiting& image : waiting_) discard(image);
  waiting_.clear();
}

void InfoMatcher::clear() {
  waiting_.clear();
  approximate_matches_.clear();
  lost_stamps_.clear();
  unpaired_since_.reset();
}

void InfoMatcher::discard(const Waiting& image) {
  constexpr std::size_t kRemembered = 1000;
  ++lost_images_;
  lost_stamps_.push_back(image.message.image->header.stamp);
  if (lost_stamps_.size() > kRemembered) lost_stamps_.pop_front();
}

bool InfoMatcher::mustFallBack(TimePoint now) const {
  constexpr std::chrono::seconds kLongest(1);
  if (matching_ != InfoMatching::kAuto || !unpaired_since_) return false;
  return fallback_rule_ == FallbackRule::kWhenFull ? waiting_.size() >= capacity_
                                                   : now - *unpaired_since_ >= kLongest;
}

void InfoMatcher::fallBack(const InfoHistory& infos, Frames& frames) {
  const std::size_t before = frames.size();
  matchNewest(infos, frames);
  has_fallen_back_ |= frames.size() > before;
}

// Images from before the last exact pair are not appended: their frames would be out of order.
void InfoMatcher::matchNewest(const InfoHistory& infos, Frames& frames) {
  constexpr std::size_t kRemembered = 10;
  for (auto image = waiting_.begin(); image != waiting_.end();) {
    const auto info = image->number > last_exact_ ? newestFor(*image->message.image, infos) : nullptr;
    if (!info) {
      ++image;
      continue;
    }
    frames.push_back(frameOf(image->message, info));
    approximate_matches_.push_back({image->message.image->header.stamp, image->number});
    if (approximate_matches_.size() > kRemembered) approximate_matches_.pop_front();
    image = waiting_.erase(image);
  }
}

void InfoMatcher::recordExactMatch(std::uint64_t number) {
  last_exact_ = std::max(last_exact_, number);
  unpaired_since_.reset();
  has_fallen_back_ = false;
  approximate_matches_.clear();
}

sensor_msgs::CameraInfoConstPtr InfoMatcher::newestFor(const sensor_msgs::Image& image,
                                                       const InfoHistory& infos) const {
  return infos.newestFor(image, matching_ == InfoMatching::kAuto);
}

}  // namespace line_plane_segmentation
