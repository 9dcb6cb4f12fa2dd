// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation::simulation {

/// Number that is linear in the pixel coordinates: per_column u + per_row v + constant.
///
/// Both the inverse depth where a pixel's ray r = ((u - cx) / fx, (v - cy) / fy, 1) meets a plane and what
/// decides if it passes through a polygon are of this kind: the scalar product of r with a vector. So a
/// face needs no clipping at the picture's borders, nor one behind the camera (Olano and Greer, "Triangle
/// scan conversion using 2D homogeneous coordinates", 1997).
struct LinearInPixels {
  double per_column = 0.0;
  double per_row = 0.0;
  double constant = 0.0;

  double inRow(int v) const { return per_row * v + constant; }
};

/// Returns the scalar product of `vector` with each pixel's ray.
inline LinearInPixels productWithRays(const Eigen::Vector3d& vector, const CameraIntrinsics& k) {
  const double per_column = vector.x() / k.fx;
  const double per_row = vector.y() / k.fy;
  return {per_column, per_row, vector.z() - per_column * k.cx - per_row * k.cy};
}

/// Columns of one row, both ends included.
struct ColumnSpan {
  double first = 0.0;
  double last = -1.0;

  /// Keeps the columns where slope u + offset >= 0.
  void cut(double slope, double offset) {
    if (slope > 0.0) {
      first = std::max(first, -offset / slope);
    } else if (slope < 0.0) {
      last = std::min(last, -offset / slope);
    } else if (!(offset >= 0.0)) {
      last = -1.0;
    }
  }

  bool empty() const { return !(std::ceil(first) <= std::floor(last)); }
  int begin() const { return static_cast<int>(std::ceil(first)); }
  int end() const { return static_cast<int>(std::floor(last)) + 1; }
};

/// Row that is being rendered.
struct ImageRow {
  std::vector<double> inverse_depth;  ///< [1/m] of the nearest surface so far, 0 = none
  std::vector<std::int64_t> labels;   ///< of the same size as the depths, so that loops can be vectorised

  explicit ImageRow(std::size_t width) : inverse_depth(width), labels(width) {}

  ColumnSpan allColumns() const { return {0.0, static_cast<double>(labels.size()) - 1.0}; }

  void clear() {
    std::fill(inverse_depth.begin(), inverse_depth.end(), 0.0);
    std::fill(labels.begin(), labels.end(), 0);
  }
};

}  // namespace line_plane_segmentation::simulation
