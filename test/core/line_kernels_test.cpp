// SPDX-License-Identifier: BSD-3-Clause
// The kernel twice: against plain sums, and against itself compiled without vectors, bit by bit.
#include "lines/line_kernels.h"

#include <gtest/gtest.h>

#include <vector>

#include "lines/line_sums.h"
#include "scalar_kernels.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

namespace scalar = ::scalar_twin::line_plane_segmentation;

LineSumLanes lanesOf(std::vector<double>& sums, int windows) {
  double* s = sums.data();
  return {s, s + windows, s + 2 * windows, s + 3 * windows, s + 4 * windows, s + 5 * windows};
}

/// The sums of one pixel, in double precision.
LineSums sumsOf(float z, float t) {
  if (!(z > 0.0F)) return {};
  const double ray = static_cast<double>(t), rho = static_cast<double>(1.0F / z);
  return {1.0, ray, ray * ray, rho, ray * rho, rho * rho};
}

LineSums windowOf(const std::vector<double>& sums, int windows, int i) {
  const double* s = sums.data() + i;
  return {s[0], s[windows], s[2 * windows], s[3 * windows], s[4 * windows], s[5 * windows]};
}

TEST(LineKernels, SumWindowsOfValidPixels) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const int windows = random.integer(1, 40), pixels = random.integer(1, 12);
    std::vector<float> z, t;
    for (int i = 0; i < windows * pixels; ++i) {
      z.push_back(random.chance(0.2) ? 0.0F : static_cast<float>(random.uniform(0.3, 8.0)));
      t.push_back(static_cast<float>(random.uniform(-0.6, 0.6)));
    }
    std::vector<double> sums(static_cast<std::size_t>(6 * windows), -1.0), twin = sums;
    sumWindows(z.data(), t.data(), pixels, windows, lanesOf(sums, windows));
    scalar::sumWindows(z.data(), t.data(), pixels, windows, lanesOf(twin, windows));
    ASSERT_EQ(sums, twin) << "seed " << seed;
    for (int i = 0; i < windows; ++i) {
      LineSums exact;
      for (int k = 0; k < pixels; ++k) {
        const std::size_t at = static_cast<std::size_t>(k * windows + i);
        exact = exact + sumsOf(z[at], t[at]);
      }
      const LineSums found = windowOf(sums, windows, i);
      ASSERT_EQ(found.n, exact.n);
      ASSERT_NEAR(found.t, exact.t, 1e-12);
      ASSERT_NEAR(found.tt, exact.tt, 1e-12);
      ASSERT_NEAR(found.rho, exact.rho, 1e-12);
      ASSERT_NEAR(found.t_rho, exact.t_rho, 1e-12);
      ASSERT_NEAR(found.rho_rho, exact.rho_rho, 1e-12);
    }
  }
}

// A line far away, whose noise is a ten-thousandth of its inverse depth: far below the single precision of
// the sums themselves.
TEST(LineKernels, KeepTheErrorOfALineFarAway) {
  constexpr int kPixels = 6, kWindows = 9;
  Random random(3);
  std::vector<float> z, t;
  for (int k = 0; k < kPixels; ++k) {
    for (int i = 0; i < kWindows; ++i) {
      t.push_back(static_cast<float>(0.5 + 0.002 * k));
      const bool is_missing = k == 0 && i % 2 == 0;
      z.push_back(is_missing ? 0.0F : static_cast<float>(8.0 + random.uniform(-8e-4, 8e-4)));
    }
  }
  std::vector<double> sums(6 * kWindows);
  sumWindows(z.data(), t.data(), kPixels, kWindows, lanesOf(sums, kWindows));
  for (std::size_t i = 0; i < kWindows; ++i) {
    LineSums exact;
    for (std::size_t k = 0; k < kPixels; ++k)
      exact = exact + sumsOf(z[k * kWindows + i], t[k * kWindows + i]);
    const LineSums found = windowOf(sums, kWindows, static_cast<int>(i));
    const double expected = fitInverseDepthLine(exact).squared_error;
    ASSERT_GT(expected, 0.0);
    EXPECT_NEAR(fitInverseDepthLine(found).squared_error, expected, 1e-3 * expected);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
