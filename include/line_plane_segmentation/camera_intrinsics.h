// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace line_plane_segmentation {

/// Pinhole camera K of the depth image. A pixel (u, v) with depth z is the point
/// ((u - cx) / fx, (v - cy) / fy, 1) * z in the optical frame: x right, y down, z forward (REP 103).
struct CameraIntrinsics {
  double fx = 0.0;  ///< [px]
  double fy = 0.0;  ///< [px]
  double cx = 0.0;  ///< [px] column of the optical axis; the centre of the first pixel is 0
  double cy = 0.0;  ///< [px] row of the optical axis

  /// Returns true if all values are finite and both focal lengths are positive.
  bool isValid() const {
    return std::isfinite(fx) && std::isfinite(fy) && std::isfinite(cx) && std::isfinite(cy) && fx > 0.0 &&
           fy > 0.0;
  }
};

}  // namespace line_plane_segmentation
