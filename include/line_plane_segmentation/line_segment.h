// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/eigen_types.h"

namespace line_plane_segmentation {

/// Direction of a scanline in the image.
enum class ScanDirection : unsigned char { kRow, kColumn };

/// Straight segment of one scanline: the line primitive of the paper.
struct LineSegment {
  ScanDirection direction = ScanDirection::kRow;
  int scanline = 0;  ///< [px] row (or column) of the image
  int first = 0;     ///< [px] column (or row) of its first point
  int last = 0;      ///< [px] column (or row) of its last point, inclusive
  int points = 0;    ///< number of valid pixels from first to last

  /// Polar form in the 2-D scan (Eq. 1-3): Sx cos(alpha) + Sy sin(alpha) = r.
  double alpha = 0.0;                              ///< [rad]
  double r = 0.0;                                  ///< [m], not negative
  Covariance2d covariance = Covariance2d::Zero();  ///< covariance of (alpha, r) from the noise model, Eq. 5
};

}  // namespace line_plane_segmentation
