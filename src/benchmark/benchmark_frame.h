// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// A depth image to measure with.
struct BenchmarkFrame {
  std::string name;
  int width = 0;                     ///< [px]
  int height = 0;                    ///< [px]
  CameraIntrinsics camera;           ///< [px]
  float depth_unit = 0.001F;         ///< [m] of one unit of `depth`
  std::vector<std::uint16_t> depth;  ///< width * height, row by row, 0 = no depth

  DepthView view() const { return viewOf(depth.data(), width, height, depth_unit); }
};

}  // namespace line_plane_segmentation
