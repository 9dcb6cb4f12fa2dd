// SPDX-License-Identifier: BSD-3-Clause
#include "depth/hole_kernels.h"

#include <cmath>

#include "kernels/multiversion.h"

// Holes can be anywhere: loops without branches, which would be mispredicted.
namespace line_plane_segmentation {

LPS_MULTIVERSION
void markValidityChanges(const float* __restrict z, int count, std::uint8_t* __restrict marks) {
  if (count > 0) marks[0] = z[0] > 0.0F ? 1 : 0;
  for (int u = 1; u < count; ++u) marks[u] = static_cast<std::uint8_t>((z[u] > 0.0F) != (z[u - 1] > 0.0F));
}

LPS_MULTIVERSION
void markHoleEnds(const float* __restrict z, int count, int v, int max_hole, int* __restrict last_valid,
                  int* __restrict holes, std::uint8_t* __restrict marks) {
  for (int u = 0; u < count; ++u) {
    const bool valid = z[u] > 0.0F;
    const int last = last_valid[u], hole = v - last - 1;
    holes[u] = hole;
    marks[u] = static_cast<std::uint8_t>(valid & (hole > 1) & (hole <= max_hole));
    last_valid[u] = valid ? v : last;
  }
}

LPS_MULTIVERSION
void fillSingleHoles(const float* before, const float* after, int count, const RowNoise& tolerance, float* z,
                     std::uint8_t* filled) {
  const RowNoise t = tolerance;
  // A pixel that is filled has two valid neighbours, which are not.
  LPS_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const float z0 = before[i], z1 = after[i], beyond = z1 - t.nearest, here = z[i];
    const float largest = (t.floor + t.growth * beyond * beyond) * z0;
    const bool is_filled = !(here > 0.0F) & (z0 > 0.0F) & (z1 > 0.0F) & (std::fabs(z1 - z0) * z1 < largest);
    z[i] = is_filled ? 2.0F * z0 * z1 / (z0 + z1) : here;
    filled[i] = static_cast<std::uint8_t>(filled[i] | static_cast<std::uint8_t>(is_filled));
  }
}

LPS_MULTIVERSION
void clearMarked(const std::uint8_t* __restrict marks, std::size_t count, float* __restrict z) {
  for (std::size_t i = 0; i < count; ++i) z[i] = marks[i] != 0 ? 0.0F : z[i];
}

LPS_MULTIVERSION
void clearWithoutDepth(const float* __restrict z, std::size_t count, std::uint16_t* __restrict labels) {
  for (std::size_t i = 0; i < count; ++i) labels[i] = z[i] > 0.0F ? labels[i] : std::uint16_t{0};
}

}  // namespace line_plane_segmentation
