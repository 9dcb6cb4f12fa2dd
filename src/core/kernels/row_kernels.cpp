// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/row_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "kernels/multiversion.h"
#include "refine/label_runs.h"

namespace line_plane_segmentation {

namespace {

// Sums over the pixels of a run. The compiler makes single steps of a loop over lanes, so these are vectors
// by name.
class RunLanes {
 public:
  static constexpr int kLanes = PixelSums::kLanes;

  // Loads the next pixels to be added; those of a depth 0 count as none.
  void load(const float* z, const double* x) {
    Depths depths;
    std::memcpy(&depths, z, sizeof(depths));
    depth_ = Lanes{depths[0], depths[1], depths[2], depths[3]};
    std::memcpy(&ray_, x, sizeof(ray_));
  }
  // Loads fewer pixels than lanes, but at least one; the other lanes repeat the last one with the depth 0.
  void loadFew(const float* z, const double* x, int pixels) {
    const int second = pixels > 1 ? 1 : 0, third = pixels > 2 ? 2 : second;
    depth_ = Lanes{z[0], z[second], z[third], 0.0};
    depth_ *= Lanes{1.0, second > 0 ? 1.0 : 0.0, third > second ? 1.0 : 0.0, 0.0};
    ray_ = Lanes{x[0], x[second], x[third], x[third]};
  }
  // Sets all loaded depths but the last ones to 0.
  void keepLast(int pixels) {
    static constexpr std::array<double, 2 * kLanes> kMask = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0};
    Lanes kept;
    std::memcpy(&kept, kMask.data() + pixels, sizeof(kept));
    depth_ *= kept;
  }
  void add() {
    const Lanes square = depth_ * depth_, square_ray = square * ray_;
    z_ += depth_;
    zx_ += depth_ * ray_;
    zz_ += square;
    zzx_ += square_ray;
    zzxx_ += square_ray * ray_;
    zzz_ += square * depth_;
  }
  void addTo(double y, PixelSums& sums) const {
    addLanes(sums.z, z_);
    addLanes(sums.zx, zx_);
    addLanes(sums.zy, y * z_);
    addLanes(sums.zz, zz_);
    addLanes(sums.zzx, zzx_);
    addLanes(sums.zzy, y * zz_);
    addLanes(sums.zzxx, zzxx_);
    addLanes(sums.zzxy, y * zzx_);
    addLanes(sums.zzyy, y * y * zz_);
    addLanes(sums.zzz, zzz_);
  }

 private:
  using Depths __attribute__((vector_size(kLanes * sizeof(float)))) = float;
  using Lanes __attribute__((vector_size(kLanes * sizeof(double)))) = double;

  static void addLanes(PixelSums::Lanes& sum, const Lanes& more) {
    Lanes lanes;
    std::memcpy(&lanes, sum.data(), sizeof(lanes));
    lanes += more;
    std::memcpy(sum.data(), &lanes, sizeof(lanes));
  }

  Lanes z_{}, zx_{}, zz_{}, zzx_{}, zzxx_{}, zzz_{};
  Lanes depth_{}, ray_{};
};

}  // namespace

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
int* compactIndices(const std::uint8_t* marks, int count, int* columns) {
  using Word = std::uint64_t;
  constexpr int kMarks = sizeof(Word);
  constexpr Word kLast = Word{1} << (kMarkBlock - 1);
  // The sum of 2^(7 j) for j = 1 to 8. Mark i, which is bit 8 i, times 2^(7 (8 - i)) is bit 56 + i: the
  // highest byte of the product has all eight marks. The other products lie below it or beyond the word, and
  // no two meet in a bit.
  constexpr Word kGather = 0x0102040810204080;
  for (int first = 0; first < count; first += kMarkBlock) {
    Word bits = 0;
    for (int i = 0; i < kMarkBlock; i += kMarks) {
      Word word;
      std::memcpy(&word, marks + first + i, sizeof(word));
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
      word = __builtin_bswap64(word);
#endif
      bits |= word * kGather >> (kMarkBlock - kMarks) << i;
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

LPS_MULTIVERSION
void addRun(const float* z, const double* x, double y, int count, PixelSums& sums) {
  constexpr int kLanes = PixelSums::kLanes;
  RunLanes run;
  if (count < kLanes) {
    run.loadFew(z, x, count);
  } else {
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) {
      run.load(z + i, x + i);
      run.add();
    }
    // What is left lies at the end of the run's last lanes; those before have been added.
    run.load(z + count - kLanes, x + count - kLanes);
    run.keepLast(count - i);
  }
  run.add();
  run.addTo(y, sums);
  sums.pixels += count;
}

}  // namespace line_plane_segmentation
