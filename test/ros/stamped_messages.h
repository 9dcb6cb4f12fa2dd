// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <string>

#include "input_frame.h"

namespace line_plane_segmentation {

inline constexpr std::uint32_t kWidth = 64;
inline constexpr std::uint32_t kHeight = 48;

/// An image without pixels.
inline DepthMessage imageAt(double stamp, const std::string& frame = "camera") {
  const auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.stamp = ros::Time(stamp);
  image->header.frame_id = frame;
  image->width = kWidth;
  image->height = kHeight;
  return {image};
}

/// A camera_info of its size.
inline sensor_msgs::CameraInfo::Ptr infoAt(double stamp, const std::string& frame = "camera") {
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header.stamp = ros::Time(stamp);
  info->header.frame_id = frame;
  info->width = kWidth;
  info->height = kHeight;
  return info;
}

}  // namespace line_plane_segmentation
