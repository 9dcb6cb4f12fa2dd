// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

#include "byte_reader.h"
#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// A small depth image of what a fuzzer may think of: planes that meet, with noise, steps and holes, or tiles
/// of any numbers.
struct DrawnScene {
  std::uint32_t width = 0;  ///< [px] from 1 to 96
  std::uint32_t height = 0;
  CameraIntrinsics camera;
  std::vector<float> depth;  ///< [m] or anything else that a float can be
};

DrawnScene drawScene(ByteReader& bytes);

/// The scene as a message of any kind that is a depth image, maybe with padding and in either byte order.
sensor_msgs::Image imageOf(const DrawnScene& scene, ByteReader& bytes);

/// The scene as an organised cloud.
sensor_msgs::PointCloud2 cloudOf(const DrawnScene& scene, ByteReader& bytes);

}  // namespace line_plane_segmentation
