// SPDX-License-Identifier: BSD-3-Clause
#include "depth/hole_filling.h"

#include <cmath>
#include <cstddef>

namespace line_plane_segmentation {
namespace {

// An image is perforated if along its rows or columns a hole comes, on average, at least every so many
// pixels. Shadows and edges of a dense image make less than a third of that.
constexpr int kPixelsPerHole = 32;
constexpr int kStride =
    29;  // between the rows and columns sampled; prime, so that no lattice hides between them

// Holes of at most `max_hole` pixels between valid ones.
int countHoles(const float* z, std::ptrdiff_t stride, int count, int max_hole) {
  int holes = 0, last_valid = -1;
  for (int i = 0; i < count; ++i, z += stride) {
    if (!(*z > 0.0F)) continue;
    const int hole = i - last_valid - 1;
    holes += (last_valid >= 0) & (hole > 0) & (hole <= max_hole) ? 1 : 0;
    last_valid = i;
  }
  return holes;
}

bool isPerforated(const DepthImage& depth, int max_hole) {
  const int in_row = depth.width / kPixelsPerHole, in_column = depth.height / kPixelsPerHole;
  int rows = 0, holes = 0;
  for (int v = kStride / 2; v < depth.height; v += kStride, ++rows)
    holes += countHoles(depth.row(v), 1, depth.width, max_hole);
  if (holes > rows * in_row) return true;
  int columns = 0;
  holes = 0;
  for (int u = kStride / 2; u < depth.width; u += kStride, ++columns)
    holes += countHoles(depth.row(0) + u, depth.width, depth.height, max_hole);
  return holes > columns * in_column;
}

}  // namespace

void HoleFiller::fillLine(float* first, std::uint8_t* filled, std::ptrdiff_t stride, int count) {
  int last_valid = -1;
  for (int i = 0; i < count; ++i) {
    const float z = first[i * stride];
    if (!(z > 0.0F)) continue;
    const int hole = i - last_valid - 1;
    if (last_valid >= 0 && hole > 0 && hole <= max_hole_) {
      const double from = 1.0 / static_cast<double>(first[last_valid * stride]),
                   to = 1.0 / static_cast<double>(z);
      const double tolerance = 2.0 * noise_factor_ * noise_.sigma(static_cast<double>(z)) * to * to;
      if (std::fabs(to - from) < tolerance) {
        for (int k = 1; k <= hole; ++k) {
          const std::ptrdiff_t at = (last_valid + k) * stride;
          first[at] = static_cast<float>(1.0 / (from + (to - from) * k / (hole + 1)));
          filled[at] = 1;
        }
      }
    }
    last_valid = i;
  }
}

bool HoleFiller::fill(const Parameters& parameters, DepthImage& depth) {
  max_hole_ = parameters.scanlines.scanline_spacing * 3 / 2;
  noise_ = parameters.noise;
  noise_factor_ = parameters.extraction.distance_noise_factor;
  if (!isPerforated(depth, max_hole_)) return false;
  filled_.assign(depth.z.size(), 0);
  for (int v = 0; v < depth.height; ++v)
    fillLine(depth.row(v), filled_.data() + depth.index(0, v), 1, depth.width);
  for (int u = 0; u < depth.width; ++u)
    fillLine(depth.row(0) + u, filled_.data() + u, depth.width, depth.height);
  return true;
}

}  // namespace line_plane_segmentation
