// SPDX-License-Identifier: BSD-3-Clause
#include "row_kernels.h"

#include <cmath>

#include "multiversion.h"

namespace line_plane_segmentation {

LPS_MULTIVERSION
void markInliers(const float* z, const float* x, int count, float a, float b, float d, float threshold,
                 std::uint8_t* mask) {
  for (int i = 0; i < count; ++i) {
    const float distance = planeDistance(z[i], x[i], a, b, d);
    mask[i] = static_cast<std::uint8_t>((z[i] > 0.0F) & (std::fabs(distance) < threshold));
  }
}

LPS_MULTIVERSION
void linkNeighbors(const float* z, const float* below, const float* x, float y, float y_below, int count, float bound,
                   std::uint8_t* links) {
  for (int i = 0; i + 1 < count; ++i) {
    const float distance = squaredDistance(z[i], x[i], y, z[i + 1], x[i + 1], y);
    links[i] = static_cast<std::uint8_t>((z[i] > 0.0F) & (z[i + 1] > 0.0F) & (distance < bound));
  }
  links[count - 1] = 0;
  if (below == nullptr) return;
  for (int i = 0; i < count; ++i) {
    const float distance = squaredDistance(z[i], x[i], y, below[i], x[i], y_below);
    const bool linked = (z[i] > 0.0F) & (below[i] > 0.0F) & (distance < bound);
    links[i] = static_cast<std::uint8_t>(links[i] | (linked ? kLinkDown : 0));
  }
}

}  // namespace line_plane_segmentation
