// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <vector>

namespace line_plane_segmentation {

/// History of the camera_info messages of one topic, indexed by timestamp. Equal calibrations are stored
/// once, so an entry needs about 100 bytes and the history can be long enough for late images. Not
/// thread-safe.
class InfoHistory {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param span   time for which a message is kept after its arrival
  /// @param count  largest number of messages, at least 1
  InfoHistory(std::chrono::steady_clock::duration span, std::size_t count) : span_(span), count_(count) {}

  /// Keeps all messages.
  InfoHistory();

  void add(const sensor_msgs::CameraInfoConstPtr& info, TimePoint arrived);

  /// Returns the calibration with exactly this timestamp that arrived last; null if there is none.
  sensor_msgs::CameraInfoConstPtr find(const ros::Time& stamp) const;

  /// Returns the newest calibration for the image's size; null if there is none.
  /// @param same_frame  true: only a calibration with the image's frame_id, or with an empty one
  sensor_msgs::CameraInfoConstPtr newestFor(const sensor_msgs::Image& image, bool same_frame) const;

  bool empty() const { return newest_.empty(); }

  /// Removes all timestamps, and keeps the newest calibrations, because a camera may send its camera_info
  /// only once.
  void clearStamps();

 private:
  struct Entry {
    TimePoint arrived;
    std::multimap<ros::Time, sensor_msgs::CameraInfoConstPtr>::iterator place;
  };

  std::chrono::steady_clock::duration span_;
  std::size_t count_;
  std::multimap<ros::Time, sensor_msgs::CameraInfoConstPtr> by_stamp_;
  std::deque<Entry> by_arrival_;
  std::vector<sensor_msgs::CameraInfoConstPtr> newest_;  // one per frame and size; the newest is the last
};

/// Returns true if image and camera_info have the same frame_id except for leading slashes, or if one of the
/// frame_ids is empty.
bool haveSameFrame(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

}  // namespace line_plane_segmentation
