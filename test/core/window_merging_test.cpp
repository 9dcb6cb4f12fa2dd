// SPDX-License-Identifier: BSD-3-Clause
// Four scanlines at a time against one window after the other, and against itself compiled for the
// plainest of machines, bit by bit.
#include "lines/window_merging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "scalar_kernels.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

namespace scalar = ::scalar_twin::line_plane_segmentation;

constexpr int kPixels = 5;  // of a window

/// A segment that grows on one scanline.
struct Segment {
  int first = 0, last = 0;
  LineSums sums;
  double squared_error = 0.0, tolerance2 = 0.0;
};

Segment segmentOf(int window, const LineSums& sums, double inv_k2, const DepthTolerance& tolerance) {
  const InverseDepthLine line = fitInverseDepthLine(sums);
  const double inverse_distance2 = line.slope * line.slope + line.offset * line.offset * inv_k2;
  return {window, window, sums, line.squared_error,
          tolerance.squaredAt(sums.rho * line.inv_n, inverse_distance2)};
}

bool mergeIfAlike(const Segment& next, const MergeRule& rule, Segment& before) {
  if (next.first - before.last > rule.max_hole) return false;
  const LineSums sums = before.sums + next.sums;
  const InverseDepthLine line = fitInverseDepthLine(sums);
  const double bound = (rule.noise_error + std::min(before.sums.n, next.sums.n)) *
                       std::min(before.tolerance2, next.tolerance2);
  if (!(line.squared_error - before.squared_error - next.squared_error < rule.fraction * bound)) return false;
  const double tolerance2 = (before.tolerance2 * before.sums.n + next.tolerance2 * next.sums.n) * line.inv_n;
  before = {before.first, next.last, sums, line.squared_error, tolerance2};
  return true;
}

std::vector<Segment> mergedOneByOne(const LineSums* sums, int windows, double inv_k2, const MergeRule& rule) {
  std::vector<Segment> segments;
  for (int i = 0; i < windows; ++i) {
    if (sums[i].n < kMinLinePixels) continue;
    const Segment next = segmentOf(i, sums[i], inv_k2, rule.tolerance);
    if (segments.empty() || !mergeIfAlike(next, rule, segments.back())) segments.push_back(next);
  }
  return segments;
}

/// The windows of a scanline of straight pieces, with noise and holes.
std::vector<LineSums> drawScanline(Random& random, int windows) {
  std::vector<LineSums> sums(static_cast<std::size_t>(windows));
  double rho = 0.5, slope = 0.0;
  for (int i = 0; i < windows; ++i) {
    if (random.chance(0.1)) {
      rho = random.uniform(0.2, 2.0);
      slope = random.uniform(-1.0, 1.0);
    }
    const bool is_hole = random.chance(0.15);
    for (int k = 0; k < kPixels; ++k) {
      if (is_hole && random.chance(0.8)) continue;
      const double t = 0.002 * (i * kPixels + k), value = rho + slope * t + 0.002 * random.gaussian();
      LineSums& s = sums[static_cast<std::size_t>(i)];
      s = s + LineSums{1.0, t, t * t, value, t * value, value * value};
    }
  }
  return sums;
}

struct Scanlines {
  std::vector<LineSums> drawn[kMergedScanlines];
  std::array<const LineSums*, kMergedScanlines> sums;
  ScanlineLanes inv_k2;
  int windows;

  Scanlines(Random& random, int window_count) : windows(window_count) {
    for (std::size_t lane = 0; lane < kMergedScanlines; ++lane) {
      drawn[lane] = drawScanline(random, windows);
      sums[lane] = drawn[lane].data();
      inv_k2[lane] = random.uniform(0.5, 1.0);
    }
  }
};

struct Merged {
  std::vector<GrowingSegments> segments;
  std::vector<StartBits> starts;

  template <typename Function>
  Merged(Function&& merge, const Scanlines& s, const MergeRule& rule)
      : segments(static_cast<std::size_t>(s.windows)),
        starts((static_cast<std::size_t>(s.windows) + 63) / 64) {
    merge(s.sums, s.inv_k2, s.windows, rule, segments.data(), starts.data());
  }

  bool startsAt(std::size_t window, std::size_t lane) const {
    return (starts[window / 64][lane] >> (window % 64) & 1U) != 0;
  }
};

MergeRule drawRule(Random& random) {
  return {random.uniform(1.0, 20.0), random.uniform(0.1, 1.0), static_cast<double>(random.integer(1, 4)),
          DepthTolerance{NoiseParameters{}, 1.6, 0.004}};
}

TEST(MergeWindows, DoesWhatMergingOneByOneDoes) {
  int merges = 0, starts = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const Scanlines scanlines(random, random.integer(1, 200));
    const MergeRule rule = drawRule(random);
    const Merged merged(mergeWindows, scanlines, rule);
    for (std::size_t lane = 0; lane < kMergedScanlines; ++lane) {
      const std::vector<Segment> expected =
          mergedOneByOne(scanlines.sums[lane], scanlines.windows, scanlines.inv_k2[lane], rule);
      std::size_t found = 0;
      for (std::size_t i = 0; i < merged.segments.size(); ++i) found += merged.startsAt(i, lane) ? 1 : 0;
      ASSERT_EQ(found, expected.size()) << "seed " << seed;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const Segment& segment = expected[k];
        ASSERT_TRUE(merged.startsAt(static_cast<std::size_t>(segment.first), lane)) << "seed " << seed;
        const std::size_t end = k + 1 < expected.size() ? static_cast<std::size_t>(expected[k + 1].first)
                                                        : merged.segments.size();
        const GrowingSegments& grown = merged.segments[end - 1];
        ASSERT_EQ(grown.last[lane], segment.last);
        ASSERT_EQ(grown.n[lane], segment.sums.n);
        ASSERT_EQ(grown.t[lane], segment.sums.t);
        ASSERT_EQ(grown.tt[lane], segment.sums.tt);
        ASSERT_EQ(grown.rho[lane], segment.sums.rho);
        ASSERT_EQ(grown.t_rho[lane], segment.sums.t_rho);
        ASSERT_EQ(grown.rho_rho[lane], segment.sums.rho_rho);
        ASSERT_EQ(grown.squared_error[lane], segment.squared_error);
        ASSERT_EQ(grown.tolerance2[lane], segment.tolerance2);
        merges += segment.last - segment.first;
        ++starts;
      }
    }
  }
  EXPECT_GT(merges, 20000);
  EXPECT_GT(starts, 10000);
}

TEST(MergeWindows, IsTheSameWithoutVectors) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Scanlines scanlines(random, random.integer(1, 200));
    const MergeRule rule = drawRule(random);
    const Merged merged(mergeWindows, scanlines, rule), twin(scalar::mergeWindows, scanlines, rule);
    ASSERT_EQ(merged.starts, twin.starts) << "seed " << seed;
    ASSERT_EQ(std::memcmp(merged.segments.data(), twin.segments.data(),
                          merged.segments.size() * sizeof(GrowingSegments)),
              0)
        << "seed " << seed;
  }
}

TEST(MergeWindows, StartsNothingWithoutPixels) {
  const std::vector<LineSums> empty(100);
  const LineSums* first = empty.data();
  std::vector<GrowingSegments> segments(empty.size());
  std::vector<StartBits> starts(2, StartBits{1, 1, 1, 1});
  mergeWindows({first, first, first, first}, {1.0, 1.0, 1.0, 1.0}, 100, {}, segments.data(), starts.data());
  EXPECT_EQ(starts, std::vector<StartBits>(2, StartBits{}));
}

}  // namespace
}  // namespace line_plane_segmentation
