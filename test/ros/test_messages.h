// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "camera_info_message.h"
#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

constexpr char kCameraFrame[] = "camera_depth_optical_frame";

/// The camera of the test images: a Kinect's field of view at any size.
inline CameraIntrinsics testCamera(std::uint32_t width, std::uint32_t height) {
  const double f = 525.0 * width / 640.0;
  return {f, f, (width - 1) / 2.0, (height - 1) / 2.0};
}

/// The ray of a pixel, at depth 1.
inline Eigen::Vector3d rayOf(const CameraIntrinsics& camera, double u, double v) {
  return {(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0};
}

inline sensor_msgs::CameraInfo testInfo(std::uint32_t width, std::uint32_t height) {
  std_msgs::Header header;
  header.frame_id = kCameraFrame;
  return makeCameraInfo(header, testCamera(width, height), static_cast<int>(width), static_cast<int>(height));
}

inline std::size_t pixelSize(const std::string& encoding) {
  return encoding == sensor_msgs::image_encodings::TYPE_32FC1 ? 4 : 2;
}

/// A packed image of this size, all 0.
inline sensor_msgs::Image testImage(std::uint32_t width, std::uint32_t height, const std::string& encoding) {
  sensor_msgs::Image image;
  image.header.frame_id = kCameraFrame;
  image.width = width;
  image.height = height;
  image.encoding = encoding;
  image.step = static_cast<std::uint32_t>(width * pixelSize(encoding));
  image.data.resize(std::size_t{image.step} * height);
  return image;
}

/// Writes a depth [m] into a 16UC1, mono16 or 32FC1 image.
inline void setDepth(sensor_msgs::Image& image, std::uint32_t u, std::uint32_t v, double z) {
  std::uint8_t* pixel = image.data.data() + std::size_t{v} * image.step + u * pixelSize(image.encoding);
  if (pixelSize(image.encoding) == 4) {
    const auto metres = static_cast<float>(z);
    std::memcpy(pixel, &metres, sizeof metres);
  } else {
    const auto millimetres = static_cast<std::uint16_t>(std::lround(1000.0 * z));
    std::memcpy(pixel, &millimetres, sizeof millimetres);
  }
}

/// Image of the plane normal . p + d = 0 from testCamera().
inline sensor_msgs::Image imageOfPlane(std::uint32_t width, std::uint32_t height, const std::string& encoding,
                                       const Eigen::Vector3d& normal, double d) {
  sensor_msgs::Image image = testImage(width, height, encoding);
  const CameraIntrinsics camera = testCamera(width, height);
  for (std::uint32_t v = 0; v < height; ++v) {
    for (std::uint32_t u = 0; u < width; ++u) {
      setDepth(image, u, v, -d / normal.dot(rayOf(camera, u, v)));
    }
  }
  return image;
}

}  // namespace line_plane_segmentation
