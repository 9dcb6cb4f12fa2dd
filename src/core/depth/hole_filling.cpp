// SPDX-License-Identifier: BSD-3-Clause
#include "depth/hole_filling.h"

#include <cmath>
#include <cstddef>

#include "depth/hole_kernels.h"
#include "kernels/row_kernels.h"

namespace line_plane_segmentation {
namespace {

// An image is perforated if along its rows or columns a hole comes, on average, at least every so many
// pixels. Shadows and edges of a dense image make less than a third of that.
constexpr int kPixelsPerHole = 32;
constexpr int kStride =
    29;  // between the rows and columns sampled; prime, so that no lattice hides between them

// Holes of at most `max_hole` pixels between valid ones.
int countHoles(const float* z, std::ptrdiff_t stride, int count, int max_hole) {
  int holes = 0, last_valid = count;  // none: no hole is that short
  for (int i = 0; i < count; ++i, z += stride) {
    const bool is_valid = *z > 0.0F;
    const int hole = i - last_valid - 1;
    holes += static_cast<int>(is_valid & (hole > 0) & (hole <= max_hole));
    last_valid = is_valid ? i : last_valid;
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

// Interpolates between valid pixels.
class HoleFiller::Interpolation {
 public:
  Interpolation(const NoiseParameters& noise, double noise_factor, float* z, std::uint8_t* filled)
      : noise_(noise),
        tolerance_(2.0 * noise_factor),
        single_tolerance_{static_cast<float>(tolerance_ * noise.floor),
                          static_cast<float>(tolerance_ * noise.growth), static_cast<float>(noise.nearest)},
        z_(z),
        filled_(filled) {}

  // Fills the holes of a single pixel among `count` pixels of a row, along the row or the column.
  void fillSingles(std::ptrdiff_t first, std::ptrdiff_t stride, int count) const {
    float* const z = z_ + first;
    fillSingleHoles(z - stride, z + stride, count, single_tolerance_, z, filled_ + first);
  }

  // Fills the pixels after `before` if those around them agree within the noise. In the inverse depth,
  // |1 / z0 - 1 / z1| < 2 k sigma(z1) / z1^2; multiplied out, since divisions would take most of the time.
  void between(std::ptrdiff_t before, std::ptrdiff_t stride, int hole) const {
    float* const first = z_ + before;
    const double z0 = static_cast<double>(first[0]), z1 = static_cast<double>(first[stride * (hole + 1)]);
    if (!(std::fabs(z1 - z0) * z1 < tolerance_ * noise_.sigma(z1) * z0)) return;
    const double product = z0 * z1 * (hole + 1), start = z1 * (hole + 1), step = z0 - z1;
    for (int k = 1; k <= hole; ++k) {
      first[stride * k] = static_cast<float>(product / (start + step * k));
      filled_[before + stride * k] = 1;
    }
  }

 private:
  NoiseParameters noise_;
  double tolerance_;
  RowNoise single_tolerance_;
  float* z_;
  std::uint8_t* filled_;
};

void HoleFiller::fillRows(const DepthImage& depth, const Interpolation& interpolation, int max_hole) {
  const Interpolation fill = interpolation;  // nothing else points to it, so that it stays in registers
  const std::ptrdiff_t width = depth.width;
  for (int v = 0; v < depth.height; ++v) {
    fill.fillSingles(v * width + 1, 1, depth.width - 2);
    markValidityChanges(depth.row(v), depth.width, marks_.data());
    // Valid pixels begin at the first of each two columns, and end before the second.
    const int* const end = compactIndices(marks_.data(), depth.width, columns_.data());
    for (const int* change = columns_.data() + 1; change + 1 < end; change += 2) {
      const int hole = change[1] - change[0];
      if (hole > 1 && hole <= max_hole) fill.between(v * width + change[0] - 1, 1, hole);
    }
  }
}

void HoleFiller::fillColumns(const DepthImage& depth, const Interpolation& interpolation, int max_hole) {
  const Interpolation fill = interpolation;
  const std::ptrdiff_t width = depth.width;
  const int* const holes = holes_.data();
  last_valid_.assign(holes_.size(), -1 - max_hole - 1);
  for (int v = 0; v < depth.height; ++v) {
    if (v > 0 && v + 1 < depth.height) fill.fillSingles(v * width, width, depth.width);
    markHoleEnds(depth.row(v), depth.width, v, max_hole, last_valid_.data(), holes_.data(), marks_.data());
    const int* const end = compactIndices(marks_.data(), depth.width, columns_.data());
    for (const int* column = columns_.data(); column < end; ++column) {
      const int hole = holes[*column];
      fill.between((v - hole - 1) * width + *column, width, hole);
    }
  }
}

bool HoleFiller::fill(const Parameters& parameters, DepthImage& depth) {
  const int max_hole = parameters.scanlines.scanline_spacing * 3 / 2;
  if (!isPerforated(depth, max_hole)) return false;
  filled_.assign(depth.z.size(), 0);
  const std::size_t width = static_cast<std::size_t>(depth.width);
  marks_.assign(width + kMarkBlock, 0);
  columns_.resize(width + kSpareColumns);
  holes_.resize(width);
  const Interpolation interpolation(parameters.noise, parameters.extraction.distance_noise_factor,
                                    depth.z.data(), filled_.data());
  fillRows(depth, interpolation, max_hole);
  fillColumns(depth, interpolation, max_hole);
  return true;
}

void HoleFiller::removeFilled(DepthImage& depth) const {
  clearMarked(filled_.data(), filled_.size(), depth.z.data());
}

}  // namespace line_plane_segmentation
