// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace line_plane_segmentation {

/// The pinhole camera K of the depth image. A pixel (u, v) of depth z is the point
/// ((u - cx) / fx, (v - cy) / fy, 1) * z in the optical frame: x right, y down, z forward (REP 103).
struct CameraIntrinsics {
  double fx = 0.0;  ///< [px]
  double fy = 0.0;  ///< [px]
  double cx = 0.0;  ///< [px] column of the optical axis, counted from the centre of the first pixel
  double cy = 0.0;  ///< [px] row of the optical axis

  /// True if points can be made with it: everything finite, both focal lengths positive.
  bool isValid() const {
    return std::isfinite(fx) && std::isfinite(fy) && std::isfinite(cx) && std::isfinite(cy) && fx > 0.0 &&
           fy > 0.0;
  }
};

}  // namespace line_plane_segmentation
