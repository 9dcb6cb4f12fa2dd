// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// Rectifies raw depth images: each pixel gets the depth that a camera without distortion would see there.
/// Depth along the optical axis does not change by that, so a rotation R is not applied: a depth camera has
/// none.
///
/// The distortion is that of camera_info: plumb_bob, rational_polynomial or equidistant. The tables are
/// computed once for each calibration. Not thread-safe.
class DepthRectifier {
 public:
  /// Takes a calibration; returns at once if it is the one before.
  /// @return false if its distortion is of an unknown kind
  bool setCamera(const sensor_msgs::CameraInfo& info, int width, int height);

  /// Returns the camera of the rectified image: that of P where P differs from K; otherwise one that sees, in
  /// an image of the same size, all that the raw image has left, right, above and below of its centre.
  const CameraIntrinsics& camera() const { return camera_; }

  /// @pre setCamera() returned true for an image of this size
  /// @return the rectified image in metres, valid until the next call
  DepthView rectify(const DepthView& raw);

 private:
  /// Where a pixel comes from: the upper left one of four, and how far it is from that one [px / 256].
  struct Source {
    std::int32_t index;  ///< -1: outside of the raw image
    std::uint8_t right;
    std::uint8_t down;
  };

  bool compute(const sensor_msgs::CameraInfo& info, int width, int height);

  std::optional<sensor_msgs::CameraInfo> info_;  // that of the tables
  bool is_known_ = false;
  int width_ = 0;
  int height_ = 0;
  CameraIntrinsics camera_;
  std::vector<Source> sources_;
  std::vector<float> raw_;
  std::vector<float> rectified_;
};

}  // namespace line_plane_segmentation
