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

/// The camera_infos of one topic, by their stamps. A calibration that does not change is stored once, so that
/// a camera_info costs some 100 bytes and images may lag far behind it.
class InfoHistory {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param span   how long a camera_info is kept after its arrival
  /// @param count  how many are kept at most; at least 1
  InfoHistory(std::chrono::steady_clock::duration span, std::size_t count) : span_(span), count_(count) {}

  /// Keeps everything.
  InfoHistory();

  void add(const sensor_msgs::CameraInfoConstPtr& info, TimePoint arrived);

  /// Returns the calibration that arrived last with exactly this stamp; null if there is none.
  sensor_msgs::CameraInfoConstPtr find(const ros::Time& stamp) const;

  /// Returns the newest calibration of the image's size; null if there is none.
  /// @param same_frame  only one of the image's frame, or without a frame
  sensor_msgs::CameraInfoConstPtr newestFor(const sensor_msgs::Image& image, bool same_frame) const;

  bool empty() const { return newest_.empty(); }

  /// Forgets the stamps. The newest calibrations stay: a camera may send its camera_info only once.
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
  std::vector<sensor_msgs::CameraInfoConstPtr> newest_;  // one of each frame and size; the newest is the last
};

/// Returns whether camera_info and image have, or may have, the same frame: leading slashes do not count, and
/// a frame that is not given may be any.
bool haveSameFrame(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

}  // namespace line_plane_segmentation
