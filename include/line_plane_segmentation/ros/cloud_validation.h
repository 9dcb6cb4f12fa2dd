// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/ros/image_validation.h"

namespace line_plane_segmentation {

/// The coordinates in an organised point cloud, whose points need not be aligned. Owns none of it.
struct CloudView {
  const std::uint8_t* data = nullptr;
  int width = 0;               ///< [px]
  int height = 0;              ///< [px]
  std::size_t row_step = 0;    ///< [bytes] from one row to the next
  std::size_t point_step = 0;  ///< [bytes] from one point to the next
  std::size_t x = 0;           ///< [bytes] from the point to its x, a float
  std::size_t y = 0;           ///< [bytes] to its y
  std::size_t z = 0;           ///< [bytes] to its z
  bool swap_bytes = false;     ///< stored in the other byte order than this machine's
};

/// Decides about a cloud before any point is read. Allocates nothing and never throws, whatever the message
/// says.
/// @param view  set if the cloud is not refused; valid as long as the message is
Refusal viewOf(const sensor_msgs::PointCloud2& cloud, const InputLimits& limits, CloudView& view);

/// The camera that an organised cloud comes from, as its points tell by x / z and y / z.
struct CloudCamera {
  Refusal refusal = Refusal::kNone;  ///< or kNotPinhole
  CameraIntrinsics camera;
  double deviation =
      0.0;  ///< [px] root mean square distance of the points to the places where the camera sees them
};

/// Fits a pinhole camera to a sample of the points. Where they are too few for that, any camera will do: so
/// few hold no plane.
CloudCamera cameraOf(const CloudView& cloud);

/// Decides about a cloud as a depth image.
/// @param depth  the z of every point, in the cloud's byte order: the bytes that the result's view looks at
Validation validate(const sensor_msgs::PointCloud2& cloud, const InputLimits& limits,
                    std::vector<std::uint8_t>& depth);

/// One line for the user: what is wrong with the cloud, and what to do about it.
std::string explain(Refusal refusal, const sensor_msgs::PointCloud2& cloud);

}  // namespace line_plane_segmentation
