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
/// there. The rotation R of camera_info is ignored, because it is the identity for a depth camera; depths
/// along the optical axis therefore stay as they are. Depth is interpolated linearly in inverse depth, and
/// not across depth steps.
///
/// The distortion is that of camera_info: plumb_bob, rational_polynomial or equidistant. The tables are
/// computed once for each calibration. Not thread-safe.
class DepthRectifier {
 public:
  /// Sets the calibration; does nothing if it has not changed.
  /// @return false if the distortion model is unknown or its coefficients are invalid
  bool setCamera(const sensor_msgs::CameraInfo& info, int width, int height);

  /// Returns the camera of the rectified image: the intrinsics of P if they differ from K; otherwise a camera
  /// with the same field of view along both axes as the raw image.
  const CameraIntrinsics& camera() const { return camera_; }

  /// Rectifies an image.
  /// @pre setCamera() returned true for an image of this size
  /// @return the rectified image in metres, valid until the next call
  DepthView rectify(const DepthView& raw);

 private:
  /// Position of a rectified pixel in the raw image: the upper left of four neighbouring pixels, and the
  /// offset from it [px / 255].
  struct SourcePixel {
    std::int32_t index;  ///< pixel index, -1 outside of the raw image
    std::uint8_t right;
    std::uint8_t down;
  };

  bool computeTables(const sensor_msgs::CameraInfo& info, int width, int height);

  // These work on inverse depths [1/m], which are linear over the image for a plane; 0 = invalid.
  float interpolate(const SourcePixel& source) const;
  float inverseDepthAt(int u, int v) const;
  float limitedSlope(int u, int v, int du, int dv) const;

  std::optional<sensor_msgs::CameraInfo> info_;  // calibration of the tables
  bool is_valid_ = false;
  int width_ = 0;
  int height_ = 0;
  CameraIntrinsics camera_;
  std::vector<SourcePixel> source_pixels_;
  std::vector<float> inverse_depth_;  // inverse depth of the raw image [1/m], 0 = invalid
  std::vector<float> rectified_;
};

}  // namespace line_plane_segmentation
