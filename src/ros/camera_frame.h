// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <chrono>

namespace line_plane_segmentation {

/// A depth image and its camera_info, or an organised point cloud in the place of both.
struct CameraFrame {
  sensor_msgs::ImageConstPtr image;                 ///< without pixels if `compressed` holds them
  sensor_msgs::CameraInfoConstPtr info;             ///< its stamp may be another than the image's
  std::chrono::steady_clock::time_point arrived{};  ///< in the queue
  sensor_msgs::PointCloud2ConstPtr cloud{};
  sensor_msgs::CompressedImageConstPtr compressed{};  ///< decoded where the frame is processed
  bool is_raw = false;  ///< the image has the lens's distortion, if camera_info tells of one

  /// Returns the header of the image or the cloud.
  const std_msgs::Header& header() const { return cloud ? cloud->header : image->header; }
};

/// A depth image as it arrives: with its pixels, or still compressed.
struct DepthMessage {
  sensor_msgs::ImageConstPtr image;
  sensor_msgs::CompressedImageConstPtr compressed{};
};

}  // namespace line_plane_segmentation
