// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace line_plane_segmentation {

/// Sums over pixels of depth z on rays (x, y, 1), whose points are z (x, y, 1). Each is kept in lanes, which
/// vectors add to and which are added up in the end.
struct PixelSums {
  static constexpr int kLanes = 4;
  using Lanes = std::array<double, kLanes>;
  Lanes z{}, zx{}, zy{}, zz{}, zzx{}, zzy{}, zzxx{}, zzxy{}, zzyy{}, zzz{};
  double pixels = 0.0;
};

}  // namespace line_plane_segmentation
