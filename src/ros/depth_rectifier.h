// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// Rectifies raw depth images: each pixel gets the depth that a camera without distortion would measure
/// there. The rotation R of camera_info is not applied, since a depth camera has none; depths along the
/// optical axis therefore stay as they are. Depth is interpolated linearly in inverse depth, and not across
/// depth steps.
///
/// The distortion is that of camera_info: plumb_bob, rational_polynomial or equidistant. The tables are
/// computed once for each calibration. Not thread-safe.
class DepthRectifier {
 public:
  /// Sets the calibration; does nothing if it has not changed.
  /// @return false if the distortion model is unknown or its coefficients are invalid
  bool setCamera(const sensor_msgs::CameraInfo& info, int width, int height);

  /// Returns the camera of the rectified image: that of P if P differs from K; otherwise one whose image of
  /// the same size ends, on both of its axes, where the raw image ends.
  const CameraIntrinsics& camera() const { return camera_; }

  /// @pre setCamera() returned true for an image of this size
  /// @return the rectified image in metres, valid until the next call
  DepthView rectify(const DepthView& raw);

 private:
  /// Position of a rectified pixel in the raw image: the upper left one of four pixels, and the offset from
  /// it [px / 255].
  struct Source {
    std::int32_t index;  ///< -1: outside of the raw image
    std::uint8_t right;
    std::uint8_t down;
  };

  bool compute(const sensor_msgs::CameraInfo& info, int width, int height);

  // All inverse depths [1/m], in which a plane is linear over the image; 0: invalid.
  float interpolate(const Source& source) const;
  float inverseDepthAt(int u, int v) const;
  float limitedSlope(int u, int v, int du, int dv) const;

  std::optional<sensor_msgs::CameraInfo> info_;  // that of the tables
  bool is_known_ = false;
  int width_ = 0;
  int height_ = 0;
  CameraIntrinsics camera_;
  std::vector<Source> sources_;
  std::vector<float> inverse_depth_;  // of the raw image [1/m], 0: invalid
  std::vector<float> rectified_;
};

}  // namespace line_plane_segmentation
