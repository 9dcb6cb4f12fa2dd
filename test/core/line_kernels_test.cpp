// SPDX-License-Identifier: BSD-3-Clause
// The kernel twice: against plain sums, and against itself compiled without vectors, bit by bit.
#include "lines/line_kernels.h"

#include <gtest/gtest.h>

#include <limits>
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
      double n = 0.0, tt = 0.0, t_rho = 0.0, spread = 0.0;
      for (int k = 0; k < pixels; ++k) {
        const std::size_t at = static_cast<std::size_t>(k * windows + i);
        if (!(z[at] > 0.0F)) continue;
        const double ray = static_cast<double>(t[at]), rho = static_cast<double>(1.0F / z[at]);
        n += 1.0;
        tt += ray * ray;
        t_rho += ray * rho;
        spread += 1.2 * 1.2 + 1.2 * 3.3;  // the most that two rays and two inverse depths are apart
      }
      const double single = spread * static_cast<double>(std::numeric_limits<float>::epsilon());
      ASSERT_EQ(sums[static_cast<std::size_t>(i)], n);
      ASSERT_NEAR(sums[static_cast<std::size_t>(2 * windows + i)], tt, 1e-12 + single);
      ASSERT_NEAR(sums[static_cast<std::size_t>(4 * windows + i)], t_rho, 1e-12 + single);
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
      z.push_back(static_cast<float>(8.0 + random.uniform(-8e-4, 8e-4)));
    }
  }
  std::vector<double> sums(6 * kWindows);
  sumWindows(z.data(), t.data(), kPixels, kWindows, lanesOf(sums, kWindows));
  for (std::size_t i = 0; i < kWindows; ++i) {
    LineSums exact;
    for (std::size_t k = 0; k < kPixels; ++k) {
      const double ray = static_cast<double>(t[k * kWindows + i]);
      const double rho = static_cast<double>(1.0F / z[k * kWindows + i]);
      exact = exact + LineSums{1.0, ray, ray * ray, rho, ray * rho, rho * rho};
    }
    const LineSums found{sums[i],
                         sums[kWindows + i],
                         sums[2 * kWindows + i],
                         sums[3 * kWindows + i],
                         sums[4 * kWindows + i],
                         sums[5 * kWindows + i]};
    const double expected = fitInverseDepthLine(exact).squared_error;
    ASSERT_GT(expected, 0.0);
    EXPECT_NEAR(fitInverseDepthLine(found).squared_error, expected, 1e-4 * expected);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
