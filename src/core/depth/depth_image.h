// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// Depth in metres, row by row, 0 where there is none: what every stage works on. No points are
/// stored; whoever needs one makes it from the depth and a ViewRays.
struct DepthImage {
  int width = 0;
  int height = 0;
  std::vector<float> z;  ///< [m] width * height

  const float* row(int v) const { return z.data() + index(0, v); }
  float* row(int v) { return z.data() + index(0, v); }
  float at(int u, int v) const { return z[index(u, v)]; }
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
};

/// Reads a whole view, as loadRow() does, into `image`, whose memory is reused.
/// @return how many pixels have a depth
std::uint32_t loadDepth(const DepthView& view, const DepthRange& range, DepthImage& image);

/// The rays through the pixels: pixel (u, v) of depth z is the point z * (x[u], y[v], 1).
struct ViewRays {
  std::vector<float> x;  ///< (u - cx) / fx for each column
  std::vector<float> y;  ///< (v - cy) / fy for each row

  /// @param camera  must be valid
  void compute(const CameraIntrinsics& camera, int width, int height);
};

}  // namespace line_plane_segmentation
