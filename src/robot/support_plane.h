// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Plane that can support objects, with a coordinate system: x and y in the plane, z (height) along the
/// normal.
struct SupportPlane {
  std::size_t index = 0;  ///< index in Segmentation::planes
  std::uint16_t label = 0;
  Eigen::Isometry3f plane_from_optical = Eigen::Isometry3f::Identity();
  std::vector<cv::Point2f> hull;  ///< [m] convex hull of its visible part

  /// Returns true if the orthogonal projection of a point (x, y) [m] is inside the hull.
  bool covers(float x, float y) const;
};

/// Computes the hull from the first and the last pixel of the plane in each row.
SupportPlane supportPlane(const Segmentation& segmentation, std::size_t index,
                          const CameraIntrinsics& camera);

}  // namespace line_plane_segmentation
