// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
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
/// If too many messages wait, the one that arrived first is discarded, whatever its stamp is.
/// message_filters::ExactTime discards the oldest stamp instead, and never finds a pair again once stamps
/// have gone back while its queue holds later ones.
class StampPairing {
 public:
  /// camera_infos that may wait: a minute at 30 Hz. Over a slow network or in a bag images arrive much later
  /// than their camera_info, which is a thousand times smaller.
  static constexpr std::size_t kMaxInfos = 1800;

  /// @param max_images  images that may wait; at least 1
  explicit StampPairing(std::size_t max_images) : max_images_(max_images) {}

  /// @return true if `frame` was made of this and of the one it waited for
  bool add(const sensor_msgs::ImageConstPtr& image, CameraFrame& frame);
  bool add(const sensor_msgs::CameraInfoConstPtr& info, CameraFrame& frame);

  /// Discards all messages that wait. They do not count as lost.
  void clear();

  /// Number of images that were discarded without a camera_info.
  std::uint64_t lostImages() const { return lost_images_; }

  /// Number of lost images whose camera_info arrived later.
  std::uint64_t lateInfos() const { return late_infos_; }

 private:
  std::size_t max_images_;
  std::deque<sensor_msgs::ImageConstPtr> images_;
  std::deque<sensor_msgs::CameraInfoConstPtr> infos_;
  std::deque<ros::Time> lost_stamps_;  // of the images that were lost last
  std::uint64_t lost_images_ = 0;
  std::uint64_t late_infos_ = 0;
};

}  // namespace line_plane_segmentation
