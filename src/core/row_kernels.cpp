// SPDX-License-Identifier: BSD-3-Clause
#include "row_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "line_plane_segmentation/label_runs.h"
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
int countDepths(const float* z, int count) {
  int depths = 0;
  for (int i = 0; i < count; ++i) depths += z[i] > 0.0F ? 1 : 0;
  return depths;
}

LPS_MULTIVERSION
void markChanges(const std::uint16_t* __restrict labels, int count, std::uint8_t* __restrict changes) {
  if (count > 0) changes[0] = 0;
  for (int i = 1; i < count; ++i) changes[i] = static_cast<std::uint8_t>(labels[i] != labels[i - 1]);
}

// Branches that depend on the picture are mispredicted half of the time. So columns are collected by
// storing all and counting the right ones.
int* appendMarked(const std::uint8_t* marks, int begin, int end, int* columns) {
  using Word = std::uint64_t;
  constexpr int kStep = sizeof(Word), kWords = 8;
  std::array<int, kWords> marked_words;
  for (int first = begin; first < end; first += kWords * kStep) {
    std::size_t count = 0;
    for (int x = first; x < std::min(end, first + kWords * kStep); x += kStep) {
      Word word;
      std::memcpy(&word, marks + x, sizeof(word));
      marked_words[count] = x;
      count += word != 0 ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
      for (int i = marked_words[k]; i < marked_words[k] + kStep; ++i) {
        *columns = i;
        columns += marks[i];
      }
    }
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
  const RowOfPlane p = plane;
  for (int i = 0; i < count; ++i) {
    const float inverse = depth_over_noise[i] < p.inverse_across ? depth_over_noise[i] : p.inverse_across;
    const float error = std::fabs(1.0F - z[i] * (p.slope * x[i] + p.offset)) * inverse;
    const bool better = error < best[i];
    best[i] = better ? error : best[i];
    label[i] = better ? p.label : label[i];
  }
}

LPS_MULTIVERSION
RunSums sumRun(const float* z, const float* x, int count) {
  constexpr int kLanes = 4;
  double sum_z[kLanes] = {}, sum_zx[kLanes] = {}, sum_zz[kLanes] = {}, sum_zzx[kLanes] = {},
         sum_zzxx[kLanes] = {}, sum_zzz[kLanes] = {};
  const auto add = [&](int lane, int i) {
    const double depth = z[i], ray = x[i], square = depth * depth, square_ray = square * ray;
    sum_z[lane] += depth;
    sum_zx[lane] += depth * ray;
    sum_zz[lane] += square;
    sum_zzx[lane] += square_ray;
    sum_zzxx[lane] += square_ray * ray;
    sum_zzz[lane] += square * depth;
  };
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) add(lane, i + lane);
  }
  for (int lane = 0; i < count; ++i, ++lane) add(lane, i);
  RunSums sums{};
  for (int lane = 0; lane < kLanes; ++lane) {
    sums.z += sum_z[lane];
    sums.zx += sum_zx[lane];
    sums.zz += sum_zz[lane];
    sums.zzx += sum_zzx[lane];
    sums.zzxx += sum_zzxx[lane];
    sums.zzz += sum_zzz[lane];
  }
  return sums;
}

}  // namespace line_plane_segmentation
