// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/PointField.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "test_messages.h"

namespace line_plane_segmentation {

/// An organised cloud of this size with all points 0. x, y and z follow a one-byte field, so that they are
/// unaligned, and rows are padded.
inline sensor_msgs::PointCloud2 testCloud(std::uint32_t width, std::uint32_t height) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = kCameraFrame;
  cloud.width = width;
  cloud.height = height;
  std::uint32_t offset = 1;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = offset;
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
    offset += 4;
  }
  cloud.point_step = 15;
  cloud.row_step = width * cloud.point_step + 3;
  cloud.data.assign(std::size_t{cloud.row_step} * height, 0);
  return cloud;
}

/// Writes coordinate 0, 1 or 2 of a point in the cloud's byte order.
inline void setCoordinate(sensor_msgs::PointCloud2& cloud, std::uint32_t u, std::uint32_t v,
                          std::size_t coordinate, double value) {
  const auto number = static_cast<float>(value);
  std::uint8_t bytes[4];
  std::memcpy(bytes, &number, sizeof bytes);
  if (cloud.is_bigendian != 0) std::reverse(bytes, bytes + 4);
  std::memcpy(cloud.data.data() + std::size_t{v} * cloud.row_step + std::size_t{u} * cloud.point_step +
                  cloud.fields.at(coordinate).offset,
              bytes, sizeof bytes);
}

inline void setPoint(sensor_msgs::PointCloud2& cloud, std::uint32_t u, std::uint32_t v,
                     const Eigen::Vector3d& point) {
  for (std::size_t i = 0; i < 3; ++i) setCoordinate(cloud, u, v, i, point[static_cast<Eigen::Index>(i)]);
}

/// Fills the cloud with the plane normal . p + d = 0 as seen by `camera`.
inline void setPlane(sensor_msgs::PointCloud2& cloud, const CameraIntrinsics& camera,
                     const Eigen::Vector3d& normal, double d) {
  for (std::uint32_t v = 0; v < cloud.height; ++v) {
    for (std::uint32_t u = 0; u < cloud.width; ++u) {
      const Eigen::Vector3d ray = rayOf(camera, u, v);
      setPoint(cloud, u, v, -d / normal.dot(ray) * ray);
    }
  }
}

}  // namespace line_plane_segmentation
