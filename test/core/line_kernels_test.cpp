// SPDX-License-Identifier: BSD-3-Clause
// The kernel twice: against plain sums, and against itself compiled without vectors, bit by bit.
#include "lines/line_kernels.h"

#include <gtest/gtest.h>

#include <vector>

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
      double n = 0.0, tt = 0.0, t_rho = 0.0;
      for (int k = 0; k < pixels; ++k) {
        const std::size_t at = static_cast<std::size_t>(k * windows + i);
        if (!(z[at] > 0.0F)) continue;
        const double ray = static_cast<double>(t[at]), rho = static_cast<double>(1.0F / z[at]);
        n += 1.0;
        tt += ray * ray;
        t_rho += ray * rho;
      }
      ASSERT_EQ(sums[static_cast<std::size_t>(i)], n);
      ASSERT_NEAR(sums[static_cast<std::size_t>(2 * windows + i)], tt, 1e-12);
      ASSERT_NEAR(sums[static_cast<std::size_t>(4 * windows + i)], t_rho, 1e-12);
    }
  }
}

}  // namespace
}  // namespace line_plane_segmentation
