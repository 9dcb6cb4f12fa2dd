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

/// A plane on which objects may stand, with coordinates of its own: (x, y) in the plane, height along the
/// normal.
struct SupportPlane {
  std::size_t index = 0;  ///< in Segmentation::planes
  std::uint16_t label = 0;
  Eigen::Isometry3f plane_from_optical = Eigen::Isometry3f::Identity();
  std::vector<cv::Point2f> hull;  ///< [m] convex hull of its visible part

  /// True if the point lies above or below the hull.
  bool covers(float x, float y) const;
};

/// Computes the hull from the first and the last pixel of the plane in each row.
SupportPlane supportPlane(const Segmentation& segmentation, std::size_t index,
                          const CameraIntrinsics& camera);

}  // namespace line_plane_segmentation
