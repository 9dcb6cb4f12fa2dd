// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {

/// A point as it is stored in the clouds' data. Field names, types and offsets follow PCL's.
struct CloudPoint {
  float x = 0.0F, y = 0.0F, z = 0.0F;
  std::uint32_t rgb = 0;    ///< PCL's packing of a colour
  std::uint32_t label = 0;  ///< as in the label image
  std::uint32_t id = 0;     ///< of the plane, 0 without a plane
};
static_assert(sizeof(CloudPoint) == 24, "no padding between the fields");

/// A cloud without points: header, fields and point_step.
sensor_msgs::PointCloud2::Ptr makeCloud(const SegmentedFrame& frame);

/// Computes the points of one row after the other.
class CloudRows {
 public:
  explicit CloudRows(const SegmentedFrame& frame);

  /// @param v  row, from 0 to below the image's height
  void load(int v);

  /// Returns true if the pixel in column `u` has a depth.
  bool hasDepth(std::size_t u) const { return depth_[u] > 0.0F; }

  /// The point of column `u`, in the frame of the messages. x, y and z are NaN without a depth.
  CloudPoint point(std::size_t u) const;

 private:
  const SegmentedFrame& frame_;
  Eigen::Matrix3f rotation_;
  Eigen::Vector3f translation_;
  std::vector<float> slopes_;         // x / z of each column
  std::vector<CloudPoint> of_label_;  // colour, label and id
  std::vector<float> depth_;          // [m] of the row
  Eigen::Vector3f row_ = Eigen::Vector3f::Zero();
  const std::uint16_t* labels_ = nullptr;  // of the row
};

}  // namespace line_plane_segmentation
