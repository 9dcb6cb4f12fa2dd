// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// The distortion of a lens, by OpenCV's models.
class LensDistortion {
 public:
  /// @return nothing if the model is unknown, or its coefficients are not as many as it has
  static std::optional<LensDistortion> of(const sensor_msgs::CameraInfo& info);

  /// Returns the pixels where a lens sees these points (x, y, 1).
  /// @param camera  K of the image
  std::vector<cv::Point2d> project(const std::vector<cv::Point2d>& points,
                                   const CameraIntrinsics& camera) const;

  /// Returns up to where x grows with the pixel: beyond, the polynomials of a model turn around, and mean
  /// nothing.
  double largestRadius(const CameraIntrinsics& camera) const;

 private:
  bool is_fisheye_ = false;
  std::vector<double> coefficients_;
};

}  // namespace line_plane_segmentation
