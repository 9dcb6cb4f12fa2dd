// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <chrono>
#include <cstddef>
#include <deque>

namespace line_plane_segmentation {

/// A depth image and the camera_info of the same stamp, or an organised point cloud in the place of both.
struct CameraFrame {
  sensor_msgs::ImageConstPtr image;
  sensor_msgs::CameraInfoConstPtr info;
  std::chrono::steady_clock::time_point arrived{};  ///< in the queue
  sensor_msgs::PointCloud2ConstPtr cloud{};

  /// Of the image or the cloud.
  const std_msgs::Header& header() const { return cloud ? cloud->header : image->header; }
};

/// Pairs images with the camera_info of exactly their stamp, whichever comes first.
///
/// Whatever waits longest gives way when too much waits: the order of arrival counts, not that of the
/// stamps. message_filters' ExactTime throws out the oldest stamp instead, and so never finds a pair
/// again once stamps have gone back and its queue holds later ones.
class StampPairing {
 public:
  /// @param capacity  images, and as many camera_infos, that wait at most; at least 1
  explicit StampPairing(std::size_t capacity) : capacity_(capacity) {}

  /// @return true if `frame` was made of this and of the one it waited for
  bool add(const sensor_msgs::ImageConstPtr& image, CameraFrame& frame);
  bool add(const sensor_msgs::CameraInfoConstPtr& info, CameraFrame& frame);

  /// Forgets everything that waits.
  void clear();

 private:
  std::size_t capacity_;
  std::deque<sensor_msgs::ImageConstPtr> images_;
  std::deque<sensor_msgs::CameraInfoConstPtr> infos_;
};

}  // namespace line_plane_segmentation
