// SPDX-License-Identifier: BSD-3-Clause
#include "info_history.h"

#include <algorithm>
#include <limits>
#include <string>

#include "image_validation.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxCalibrations = 16;  // of other frames and sizes, on one topic

bool isSameRegion(const sensor_msgs::RegionOfInterest& a, const sensor_msgs::RegionOfInterest& b) {
  return a.x_offset == b.x_offset && a.y_offset == b.y_offset && a.width == b.width && a.height == b.height &&
         a.do_rectify == b.do_rectify;
}

bool isSameKind(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  return a.header.frame_id == b.header.frame_id && a.width == b.width && a.height == b.height &&
         a.binning_x == b.binning_x && a.binning_y == b.binning_y && isSameRegion(a.roi, b.roi);
}

// Equal in all but stamp and sequence number.
bool isSameCalibration(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  return isSameKind(a, b) && a.distortion_model == b.distortion_model && a.D == b.D && a.K == b.K &&
         a.R == b.R && a.P == b.P;
}

std::string withoutSlashes(const std::string& frame) {
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

}  // namespace

InfoHistory::InfoHistory()
    : InfoHistory(std::chrono::steady_clock::duration::max(), std::numeric_limits<std::size_t>::max()) {}

void InfoHistory::add(const sensor_msgs::CameraInfoConstPtr& info, TimePoint arrived) {
  sensor_msgs::CameraInfoConstPtr shared = info;
  if (!newest_.empty() && isSameCalibration(*newest_.back(), *info)) {
    shared = newest_.back();
  } else {
    newest_.erase(std::remove_if(newest_.begin(), newest_.end(),
                                 [&](const auto& other) { return isSameKind(*other, *info); }),
                  newest_.end());
    if (newest_.size() == kMaxCalibrations) newest_.erase(newest_.begin());
    newest_.push_back(info);
  }
  by_arrival_.push_back({arrived, by_stamp_.emplace(info->header.stamp, shared)});
  while (by_arrival_.size() > count_ || arrived - by_arrival_.front().arrived > span_) {
    by_stamp_.erase(by_arrival_.front().place);
    by_arrival_.pop_front();
  }
}

sensor_msgs::CameraInfoConstPtr InfoHistory::find(const ros::Time& stamp) const {
  const auto after = by_stamp_.upper_bound(stamp);
  if (after == by_stamp_.begin()) return {};
  const auto& [found, info] = *std::prev(after);
  return found == stamp ? info : nullptr;
}

sensor_msgs::CameraInfoConstPtr InfoHistory::newestFor(const sensor_msgs::Image& image,
                                                       bool same_frame) const {
  const auto found = std::find_if(newest_.rbegin(), newest_.rend(), [&](const auto& info) {
    return sizesMatch(image, *info) && (!same_frame || haveSameFrame(image, *info));
  });
  return found == newest_.rend() ? nullptr : *found;
}

void InfoHistory::clearStamps() {
  by_stamp_.clear();
  by_arrival_.clear();
}

bool haveSameFrame(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info) {
  const std::string a = withoutSlashes(image.header.frame_id);
  const std::string b = withoutSlashes(info.header.frame_id);
  return a.empty() || b.empty() || a == b;
}

}  // namespace line_plane_segmentation
