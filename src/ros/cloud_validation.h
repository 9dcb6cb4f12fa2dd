// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "image_validation.h"
#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// Non-owning view of the coordinates of an organised point cloud. Points may be unaligned.
struct CloudView {
  const std::uint8_t* data = nullptr;
  int width = 0;               ///< [px]
  int height = 0;              ///< [px]
  std::size_t row_step = 0;    ///< [bytes] from one row to the next
  std::size_t point_step = 0;  ///< [bytes] from one point to the next
  std::size_t x = 0;           ///< [bytes] offset of x, a float, in the point
  std::size_t y = 0;           ///< [bytes] offset of y
  std::size_t z = 0;           ///< [bytes] offset of z
  bool swap_bytes = false;     ///< true if the byte order differs from the host's
};

/// Validates a cloud before any point is read. Does not allocate and never throws, for any message.
/// @param view  set if the cloud is accepted; valid as long as the message
Refusal viewOf(const sensor_msgs::PointCloud2& cloud, const InputLimits& limits, CloudView& view);

/// Pinhole camera of an organised cloud, estimated from x / z and y / z of its points.
struct CloudCamera {
  Refusal refusal = Refusal::kNone;  ///< kNone, or kNotPinhole if no pinhole camera fits
  CameraIntrinsics camera;
  double deviation = 0.0;  ///< [px] root mean square distance of pixels from the projections of their points
};

/// Fits a pinhole camera to a sample of the points. If they are too few, the camera is arbitrary; so few
/// points contain no plane.
CloudCamera cameraOf(const CloudView& cloud);

/// Validates a cloud and converts it to a depth image.
/// @param depth  z of every point, in the cloud's byte order; referenced by the view of the result
Validation validate(const sensor_msgs::PointCloud2& cloud, const InputLimits& limits,
                    std::vector<std::uint8_t>& depth);

/// Returns one line for the user: the fault of the cloud and its remedy.
std::string explain(Refusal refusal, const sensor_msgs::PointCloud2& cloud);

}  // namespace line_plane_segmentation
