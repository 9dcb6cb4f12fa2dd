// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <chrono>

namespace line_plane_segmentation {

/// Input of one segmentation: a depth image with its camera_info, or an organised point cloud.
struct InputFrame {
  sensor_msgs::ImageConstPtr image;      ///< header and size only if `compressed` is set; null for a cloud
  sensor_msgs::CameraInfoConstPtr info;  ///< its timestamp may differ from the image's; null for a cloud
  std::chrono::steady_clock::time_point arrived{};  ///< time of arrival in the mailbox
  sensor_msgs::PointCloud2ConstPtr cloud{};
  sensor_msgs::CompressedImageConstPtr compressed{};  ///< decoded when the frame is processed
  bool needs_rectification = false;                   ///< rectify the image if camera_info has distortion

  /// Returns the header of the image or the cloud.
  const std_msgs::Header& header() const { return cloud ? cloud->header : image->header; }
};

/// Received depth image: with its pixels, or compressed and without pixels.
struct DepthMessage {
  sensor_msgs::ImageConstPtr image;
  sensor_msgs::CompressedImageConstPtr compressed{};
};

}  // namespace line_plane_segmentation
