// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/row_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "kernels/multiversion.h"
#include "refine/label_runs.h"

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
int countInliers(const float* z, const float* x, int count, float a, float b, float d, float threshold) {
  int inliers = 0;
  for (int i = 0; i < count; ++i) {
    const float distance = planeDistance(z[i], x[i], a, b, d);
    inliers += ((z[i] > 0.0F) & (std::fabs(distance) < threshold)) ? 1 : 0;
  }
  return inliers;
}

LPS_MULTIVERSION
void markRunBoundaries(const std::uint8_t* __restrict mask, const std::uint8_t* __restrict links, int count,
                       std::uint8_t* __restrict boundaries) {
  if (count > 0) boundaries[0] = mask[0];
  for (int i = 1; i < count; ++i) {
    const std::uint8_t unlinked = static_cast<std::uint8_t>(~links[i - 1] & kLinkRight);
    boundaries[i] = static_cast<std::uint8_t>((mask[i] ^ mask[i - 1]) | (mask[i] & mask[i - 1] & unlinked));
  }
}

LPS_MULTIVERSION
void linkNeighbors(const float* z, const float* below, const float* x, float y, float y_below, int count,
                   float bound, std::uint8_t* links) {
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

LPS_MULTIVERSION
void markChanges(const std::uint16_t* __restrict labels, int count, std::uint8_t* __restrict changes) {
  if (count > 0) changes[0] = 0;
  for (int i = 1; i < count; ++i) changes[i] = static_cast<std::uint8_t>(labels[i] != labels[i - 1]);
}

// Branches that depend on the picture are mispredicted half of the time. So a few columns of each block are
// stored whether they are marked or not, which is mostly enough, and the marked ones are counted.
LPS_MULTIVERSION
int* appendMarked(const std::uint8_t* marks, int count, int* columns) {
  using Word = std::uint64_t;
  constexpr int kMarks = sizeof(Word);
  constexpr Word kLast = Word{1} << (kMarkBlock - 1);
  for (int first = 0; first < count; first += kMarkBlock) {
    Word bits = 0;
    for (int i = 0; i < kMarkBlock; i += kMarks) {
      Word word;
      std::memcpy(&word, marks + first + i, sizeof(word));
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
      word = __builtin_bswap64(word);
#endif
      // Each mark is multiplied into a bit of the highest byte.
      bits |= word * 0x0102040810204080 >> (kMarkBlock - kMarks) << i;
    }
    int* const end = columns + __builtin_popcountll(bits);
    for (int k = 0; k < kSpareColumns; ++k, bits &= bits - 1)
      columns[k] = first + __builtin_ctzll(bits | kLast);
    for (int* next = columns + kSpareColumns; next < end; ++next, bits &= bits - 1)
      *next = first + __builtin_ctzll(bits);
    columns = end;
  }
  return columns;
}

LPS_MULTIVERSION
void prepareRow(const float* __restrict z, int count, const RowNoise& noise,
                float* __restrict depth_over_noise, float* __restrict best, std::uint16_t* __restrict label) {
  const RowNoise n = noise;
  for (int i = 0; i < count; ++i) {
    const bool valid = z[i] > 0.0F;
    const float beyond = z[i] - n.nearest;
    depth_over_noise[i] = z[i] / (n.floor + n.growth * beyond * beyond);
    best[i] = valid ? 1.0F : 0.0F;
    label[i] = valid ? std::uint16_t{0} : kNoDepthLabel;
  }
}

LPS_MULTIVERSION
void assignIfBetter(const float* __restrict z, const float* __restrict depth_over_noise,
                    const float* __restrict x, int count, const RowOfPlane& plane, float* __restrict best,
                    std::uint16_t* __restrict label) {
  constexpr int kBlock = 16, kHalf = kBlock / 2;
  const RowOfPlane p = plane;
  const auto assign = [&](int first, int pixels) {
    for (int i = first; i < first + pixels; ++i) {
      const float inverse =
          depth_over_noise[i] < p.inv_orthogonal_tolerance ? depth_over_noise[i] : p.inv_orthogonal_tolerance;
      const float error = std::fabs(1.0F - z[i] * (p.slope * x[i] + p.offset)) * inverse;
      const float lowest = best[i];
      const std::uint16_t before = label[i];
      best[i] = std::min(error, lowest);
      label[i] = error < lowest ? p.label : before;
    }
  };
  if (count < kHalf) return assign(0, count);
  if (count < kBlock) {
    assign(0, kHalf);
    return assign(count - kHalf, kHalf);
  }
  for (int first = 0; first + kBlock <= count; first += kBlock) assign(first, kBlock);
  // Most rows are short, so what is left would take as long pixel by pixel. The last block lies over the one
  // before; to ask a pixel a second time changes nothing.
  assign(count - kBlock, kBlock);
}

// The compiler makes single steps of a loop over lanes, so these are vectors by name.
LPS_MULTIVERSION
void addRun(const float* z, const double* x, double y, int count, PixelSums& sums) {
  constexpr int kLanes = PixelSums::kLanes;
  using Depths __attribute__((vector_size(kLanes * sizeof(float)))) = float;
  using Lanes __attribute__((vector_size(kLanes * sizeof(double)))) = double;
  static constexpr std::array<double, 2 * kLanes> kMask = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0};

  Lanes sum_z{}, sum_zx{}, sum_zz{}, sum_zzx{}, sum_zzxx{}, sum_zzz{};
  // The next pixels to be added, those of a depth 0 being none.
  Lanes depth{}, ray{};
  const auto load = [&](int first) {
    Depths depths;
    std::memcpy(&depths, z + first, sizeof(depths));
    depth = Lanes{depths[0], depths[1], depths[2], depths[3]};
    std::memcpy(&ray, x + first, sizeof(ray));
  };
  const auto add = [&]() {
    const Lanes square = depth * depth, square_ray = square * ray;
    sum_z += depth;
    sum_zx += depth * ray;
    sum_zz += square;
    sum_zzx += square_ray;
    sum_zzxx += square_ray * ray;
    sum_zzz += square * depth;
  };
  if (count < kLanes) {
    for (int i = 0; i < count; ++i) {
      depth[i] = static_cast<double>(z[i]);
      ray[i] = x[i];
    }
  } else {
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) {
      load(i);
      add();
    }
    // What is left lies at the end of the run's last lanes; those before have been added.
    Lanes kept;
    std::memcpy(&kept, kMask.data() + (count - i), sizeof(kept));
    load(count - kLanes);
    depth *= kept;
  }
  add();

  const auto addTo = [](PixelSums::Lanes& sum, const Lanes& more) {
    Lanes lanes;
    std::memcpy(&lanes, sum.data(), sizeof(lanes));
    lanes += more;
    std::memcpy(sum.data(), &lanes, sizeof(lanes));
  };
  addTo(sums.z, sum_z);
  addTo(sums.zx, sum_zx);
  addTo(sums.zy, y * sum_z);
  addTo(sums.zz, sum_zz);
  addTo(sums.zzx, sum_zzx);
  addTo(sums.zzy, y * sum_zz);
  addTo(sums.zzxx, sum_zzxx);
  addTo(sums.zzxy, y * sum_zzx);
  addTo(sums.zzyy, y * y * sum_zz);
  addTo(sums.zzz, sum_zzz);
  sums.pixels += count;
}

}  // namespace line_plane_segmentation
