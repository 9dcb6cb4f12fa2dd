// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "conversions.h"

namespace line_plane_segmentation {

/// Point of a cloud message. Field names, types and offsets follow PCL.
struct CloudPoint {
  float x = 0.0F, y = 0.0F, z = 0.0F;
  std::uint32_t rgb = 0;    ///< colour as packed by PCL
  std::uint32_t label = 0;  ///< label of the plane, 0 without a plane
  std::uint32_t id = 0;     ///< id of the plane, 0 without a plane
};
static_assert(sizeof(CloudPoint) == 24, "no padding between the fields");

/// Returns a cloud without points: header, fields and point_step only.
sensor_msgs::PointCloud2::Ptr makeCloud(const SegmentedFrame& frame);

/// Computes the points of an image row by row, in the target frame [m]. The frame must outlive this object.
class CloudRows {
 public:
  explicit CloudRows(const SegmentedFrame& frame);

  /// Selects and reads a row.
  /// @param v  row, from 0 to height - 1
  void load(int v);

  /// Returns true if the pixel in column `u` of the row has a valid depth.
  bool hasDepth(std::size_t u) const { return depth_[u] > 0.0F; }

  /// Returns the point of column `u` of the row in the target frame [m]. x, y and z are NaN if the depth is
  /// invalid.
  CloudPoint point(std::size_t u) const;

 private:
  const SegmentedFrame& frame_;
  Eigen::Matrix3f rotation_;
  Eigen::Vector3f translation_;
  std::vector<float> slopes_;         // x / z per column
  std::vector<CloudPoint> of_label_;  // colour, label and id per label
  std::vector<float> depth_;          // depth of the row [m], 0 = invalid
  Eigen::Vector3f row_ = Eigen::Vector3f::Zero();
  const std::uint16_t* labels_ = nullptr;  // labels of the row
};

}  // namespace line_plane_segmentation
