// SPDX-License-Identifier: BSD-3-Clause
// Where scanlines lie, and the sums of their windows.
#include "lines/scanline_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);
const ViewRays kRays = raysOf(kCamera, kWidth, kHeight);

TEST(WindowSummer, SumsThePixelsOfEachWindow) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const int width = random.integer(1, 90), height = random.integer(1, 70);
    DepthImage depth = randomScene(seed, width, height);
    addHoles(0.2, 1, random, depth);
    const ViewRays rays = raysOf(kCamera, width, height);
    ScanlineSet rows, columns;
    WindowSummer().sum(depth, rays, random.integer(1, 12), random.integer(1, 9), rows, columns);
    for (const ScanlineSet* set : {&rows, &columns}) {
      const bool is_row = set == &rows;
      for (int k = 0; k < set->count(); ++k) {
        const int at = set->pixels[static_cast<std::size_t>(k)], length = is_row ? width : height;
        for (int w = 0; w < set->windows; ++w) {
          double n = 0.0, t_rho = 0.0, rho_rho = 0.0;
          for (int i = w * set->window; i < std::min(length, (w + 1) * set->window); ++i) {
            const float z = is_row ? depth.at(i, at) : depth.at(at, i);
            if (!(z > 0.0F)) continue;
            const double rho = static_cast<double>(1.0F / z);
            n += 1.0;
            t_rho += rho * static_cast<double>((is_row ? rays.x : rays.y)[static_cast<std::size_t>(i)]);
            rho_rho += rho * rho;
          }
          const LineSums& sums = set->sums[set->indexOf(k, w)];
          ASSERT_EQ(sums.n, n) << "seed " << seed;
          ASSERT_NEAR(sums.t_rho, t_rho, 1e-9);
          ASSERT_NEAR(sums.rho_rho, rho_rho, 1e-9);
        }
      }
    }
  }
}

TEST(WindowSummer, MovesScanlinesOffMissingRowsAndColumns) {
  DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  for (int v = 5; v < kHeight; v += 10) std::fill_n(depth.row(v), kWidth, 0.0F);
  constexpr int kSpacing = 10, kWindow = 5;  // every scanline would be missing
  ScanlineSet rows, columns;
  WindowSummer().sum(depth, kRays, kSpacing, kWindow, rows, columns);
  for (const int v : rows.pixels) EXPECT_NE(v % kSpacing, 5);
  for (const LineSums& sums : rows.sums) EXPECT_GT(sums.n, 0.0);
  const DepthImage dense = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  WindowSummer().sum(dense, kRays, kSpacing, kWindow, rows, columns);
  for (const int v : rows.pixels) EXPECT_EQ(v % kSpacing, 5);
}

/// The first row that is scanned, if only a fraction of the pixels is valid in the row that is due.
int firstRowOf(int spacing, double fraction) {
  DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  std::fill_n(depth.row(spacing / 2), static_cast<int>((1.0 - fraction) * kWidth), 0.0F);
  ScanlineSet rows, columns;
  WindowSummer().sum(depth, kRays, spacing, 5, rows, columns);
  return rows.pixels.front();
}

TEST(WindowSummer, MovesARowToWhereTwiceAsManyPixelsAreValid) {
  EXPECT_EQ(firstRowOf(10, 0.6), 5);
  EXPECT_EQ(firstRowOf(10, 0.4), 4);
}

/// Where scanlines lie, each of which may move to a neighbour with more than twice as many valid pixels.
template <typename CountValid>
std::vector<int> placed(int length, int spacing, CountValid&& count_valid) {
  std::vector<int> pixels;
  for (int at = spacing / 2; at < length; at += spacing) {
    int best = at, most = 2 * count_valid(at);
    for (const int other : {at - 1, at + 1}) {
      if (spacing < 3 || other < 0 || other >= length || count_valid(other) <= most) continue;
      best = other;
      most = count_valid(other);
    }
    pixels.push_back(best);
  }
  return pixels;
}

TEST(WindowSummer, MovesEachScanlineByItself) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const int width = random.integer(1, 30), height = random.integer(1, 30), spacing = random.integer(1, 6);
    DepthImage depth = render(surfaceAt(1.5), kCamera, width, height);
    for (int v = 0; v < height; ++v) {
      const double invalid = random.uniform(0.0, 1.0);
      for (int u = 0; u < width; ++u) {
        if (random.chance(invalid) || (seed % 2 == 0 && u % 3 != 0)) depth.row(v)[u] = 0.0F;
      }
    }
    ScanlineSet rows, columns;
    WindowSummer().sum(depth, raysOf(kCamera, width, height), spacing, 5, rows, columns);
    const auto is_valid = [&depth](int u, int v) { return depth.at(u, v) > 0.0F ? 1 : 0; };
    EXPECT_EQ(rows.pixels, placed(height, spacing, [&](int v) {
                int valid = 0;
                for (int u = 0; u < width; ++u) valid += is_valid(u, v);
                return valid;
              }));
    EXPECT_EQ(columns.pixels, placed(width, spacing, [&](int u) {
                int valid = 0;
                for (int v = 0; v < height; v += 5) valid += is_valid(u, v);
                return valid;
              }));
    for (const int u : columns.pixels) moved += u % spacing != spacing / 2 ? 1 : 0;
    for (const int v : rows.pixels) moved += v % spacing != spacing / 2 ? 1 : 0;
  }
  EXPECT_GT(moved, 100);
}

TEST(WindowSummer, MovesNoRowTowardsOneThatIsScanned) {
  EXPECT_EQ(firstRowOf(2, 0.1), 1);
  EXPECT_EQ(firstRowOf(3, 0.1), 0);
}

}  // namespace
}  // namespace line_plane_segmentation
