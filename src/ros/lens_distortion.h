// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// Lens distortion by OpenCV's models: plumb_bob and rational_polynomial (4, 5, 8, 12 or 14 coefficients),
/// equidistant (4). image_geometry::PinholeCameraModel projects point by point, which takes seconds for the
/// table of a VGA image, and does not check the number of coefficients.
class LensDistortion {
 public:
  /// Reads model and coefficients.
  /// @return empty if the model is unknown, or the number of coefficients does not fit it
  static std::optional<LensDistortion> fromCameraInfo(const sensor_msgs::CameraInfo& info);

  /// Projects the points (x, y, 1) to pixels.
  /// @param camera  intrinsics K of the raw image
  std::vector<cv::Point2d> project(const std::vector<cv::Point2d>& points,
                                   const CameraIntrinsics& camera) const;

  /// Returns the largest radius sqrt(x² + y²) up to which the projection increases monotonically. Beyond it
  /// the polynomials of a model are invalid.
  double maxMonotonicRadius(const CameraIntrinsics& camera) const;

 private:
  bool is_fisheye_ = false;
  std::vector<double> coefficients_;
};

}  // namespace line_plane_segmentation
