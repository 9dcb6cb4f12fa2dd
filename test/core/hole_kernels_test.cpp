// SPDX-License-Identifier: BSD-3-Clause
// The kernel twice: against its definition in double precision, and against itself compiled without vectors,
// bit by bit.
#include "depth/hole_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "scalar_kernels.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

namespace scalar = ::scalar_twin::line_plane_segmentation;

constexpr RowNoise kTolerance{0.002F, 0.003F, 0.4F};

/// Pixels around which the kernel may look `stride` pixels to either side.
struct Pixels {
  int stride, count;
  std::vector<float> z;
  std::vector<std::uint8_t> filled;

  template <typename Depth>
  Pixels(int pixels_apart, int pixels, Depth&& depth) : stride(pixels_apart), count(pixels) {
    for (int i = 0; i < count + 2 * stride; ++i) z.push_back(depth(i));
    filled.assign(z.size(), 0);
  }

  template <typename Fill>
  Pixels filledBy(Fill&& fill) const {
    Pixels result = *this;
    float* const first = result.z.data() + stride;
    fill(first - stride, first + stride, count, kTolerance, first, result.filled.data() + stride);
    return result;
  }

  bool operator==(const Pixels& other) const { return z == other.z && filled == other.filled; }
};

/// Checks each pixel, unless its neighbours differ by nearly as much as they may.
void expectAsDefined(const Pixels& before, const Pixels& after) {
  for (int i = 0; i < before.count; ++i) {
    const std::size_t at = static_cast<std::size_t>(i + before.stride),
                      apart = static_cast<std::size_t>(before.stride);
    const double z0 = static_cast<double>(before.z[at - apart]),
                 z1 = static_cast<double>(before.z[at + apart]);
    const double beyond = z1 - static_cast<double>(kTolerance.nearest);
    const double largest =
        static_cast<double>(kTolerance.floor) + static_cast<double>(kTolerance.growth) * beyond * beyond;
    const double relative = std::fabs(z1 - z0) * z1 / (largest * z0);
    if (std::fabs(relative - 1.0) < 1e-4) continue;
    const bool is_hole = !(before.z[at] > 0.0F) && z0 > 0.0 && z1 > 0.0;
    ASSERT_EQ(after.filled[at] != 0, is_hole && relative < 1.0) << i;
    // Halfway between both in inverse depth.
    const double expected =
        after.filled[at] != 0 ? 2.0 / (1.0 / z0 + 1.0 / z1) : static_cast<double>(before.z[at]);
    ASSERT_NEAR(after.z[at], expected, 1e-6 * expected) << i;
  }
}

TEST(FillSingleHoles, FillsBetweenNeighborsOfOneSurface) {
  int filled = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    const double invalid = random.uniform(0.0, 0.8), noise = random.uniform(0.0, 0.02);
    const Pixels before(random.integer(1, 40), random.integer(0, 70), [&](int) {
      return random.chance(invalid) ? 0.0F : static_cast<float>(1.5 + noise * random.gaussian());
    });
    const Pixels after = before.filledBy(fillSingleHoles);
    ASSERT_TRUE(after == before.filledBy(scalar::fillSingleHoles)) << "seed " << seed;
    expectAsDefined(before, after);
    for (std::size_t i = 0; i < after.z.size(); ++i) {
      filled += after.filled[i];
      left += after.z[i] > 0.0F ? 0 : 1;
    }
  }
  EXPECT_GT(filled, 500);
  EXPECT_GT(left, 1000);
}

TEST(FillSingleHoles, FillsEverySecondPixelInPlace) {
  const Pixels before(1, 101, [](int i) { return i % 2 == 0 ? 2.0F : 0.0F; });
  const Pixels after = before.filledBy(fillSingleHoles);
  for (const float z : after.z) EXPECT_EQ(z, 2.0F);
}

TEST(FillSingleHoles, KeepsWhatItFilledBefore) {
  Pixels pixels(1, 3, [](int) { return 2.0F; });
  pixels.filled[2] = 1;
  EXPECT_TRUE(pixels.filledBy(fillSingleHoles) == pixels);
}

TEST(FillSingleHoles, TakesExtremeDepths) {
  for (const float depth : {1e-6F, 1000.0F}) {
    const Pixels before(1, 9, [depth](int i) { return i % 2 == 0 ? depth : 0.0F; });
    for (const float z : before.filledBy(fillSingleHoles).z) EXPECT_NEAR(z, depth, 1e-6F * depth);
  }
}

TEST(FillSingleHoles, OfNothingIsNothing) {
  const Pixels before(1, 0, [](int) { return 0.0F; });
  EXPECT_TRUE(before.filledBy(fillSingleHoles) == before);
  fillSingleHoles(nullptr, nullptr, -1, kTolerance, nullptr, nullptr);
}

}  // namespace
}  // namespace line_plane_segmentation
