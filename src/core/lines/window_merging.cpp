// SPDX-License-Identifier: BSD-3-Clause
#include "lines/window_merging.h"

#include <cstring>

#include "kernels/multiversion.h"

namespace line_plane_segmentation {
namespace {

using Doubles = double __attribute__((vector_size(sizeof(ScanlineLanes))));
using Words = std::uint64_t __attribute__((vector_size(sizeof(StartBits))));
using Sums = LineSumsOf<Doubles>;
using Line = InverseDepthLineOf<Doubles>;

// A window of each scanline.
inline void load(const std::array<const LineSums*, kMergedScanlines>& scanlines, int window, Sums& sums) {
  const LineSums &a = scanlines[0][window], &b = scanlines[1][window];
  const LineSums &c = scanlines[2][window], &d = scanlines[3][window];
  sums.n = Doubles{a.n, b.n, c.n, d.n};
  sums.t = Doubles{a.t, b.t, c.t, d.t};
  sums.tt = Doubles{a.tt, b.tt, c.tt, d.tt};
  sums.rho = Doubles{a.rho, b.rho, c.rho, d.rho};
  sums.t_rho = Doubles{a.t_rho, b.t_rho, c.t_rho, d.t_rho};
  sums.rho_rho = Doubles{a.rho_rho, b.rho_rho, c.rho_rho, d.rho_rho};
}

inline void store(const Doubles& numbers, ScanlineLanes& to) {
  std::memcpy(to.data(), &numbers, sizeof numbers);
}

// DepthTolerance::squaredAt() of the mean inverse depth.
inline void squaredTolerance(const DepthTolerance& tolerance, const Sums& sums, const Line& line,
                             const Doubles& inv_k2, Doubles& tolerance2) {
  const Doubles rho = sums.rho * line.inv_n;
  const Doubles inverse_distance2 = line.slope * line.slope + line.offset * line.offset * inv_k2;
  const Doubles reach = 1.0 - tolerance.noise.nearest * rho;
  const Doubles noise_term =
      tolerance.noise_factor * (tolerance.noise.floor * rho * rho + tolerance.noise.growth * reach * reach);
  const Doubles distance_term = tolerance.distance * rho;
  const Doubles noise2 = noise_term * noise_term,
                distance2 = distance_term * distance_term * inverse_distance2;
  tolerance2 = noise2 < distance2 ? distance2 : noise2;
}

}  // namespace

LPS_MULTIVERSION
void mergeWindows(const std::array<const LineSums*, kMergedScanlines>& sums, const ScanlineLanes& inv_k2,
                  int windows, const MergeRule& rule, GrowingSegments* segments, StartBits* starts) {
  constexpr int kBits = 64;
  const MergeRule r = rule;
  Doubles inv_k2_lanes;
  std::memcpy(&inv_k2_lanes, inv_k2.data(), sizeof inv_k2_lanes);
  // Before the first segment there is an empty one, too far away to be continued.
  Sums before;
  Doubles squared_error{}, tolerance2{}, last = Doubles{} - (r.max_hole + 1.0);
  Words bits{};
  for (int i = 0; i < windows; ++i) {
    Sums window;
    load(sums, i, window);
    const Line line = fitThroughPixels(window);
    Doubles window_tolerance2;
    squaredTolerance(r.tolerance, window, line, inv_k2_lanes, window_tolerance2);
    const Sums both = before + window;
    const Line common = fitThroughPixels(both);
    const Doubles pixels = window.n < before.n ? window.n : before.n;
    const Doubles least = window_tolerance2 < tolerance2 ? window_tolerance2 : tolerance2;
    const Doubles bound = (r.noise_error + pixels) * least;
    const Doubles index = Doubles{} + static_cast<double>(i);
    const auto is_alike = (common.squared_error - squared_error - line.squared_error < r.fraction * bound) &
                          (index - last <= r.max_hole);
    const auto is_valid = window.n >= kMinLinePixels;

    const Doubles mean_tolerance2 = (tolerance2 * before.n + window_tolerance2 * window.n) * common.inv_n;
    const auto choose = [&](const Doubles& continued, const Doubles& started, Doubles& value) {
      const Doubles next = is_alike ? continued : started;
      value = is_valid ? next : value;
    };
    choose(mean_tolerance2, window_tolerance2, tolerance2);
    choose(common.squared_error, line.squared_error, squared_error);
    choose(both.n, window.n, before.n);
    choose(both.t, window.t, before.t);
    choose(both.tt, window.tt, before.tt);
    choose(both.rho, window.rho, before.rho);
    choose(both.t_rho, window.t_rho, before.t_rho);
    choose(both.rho_rho, window.rho_rho, before.rho_rho);
    choose(index, index, last);

    GrowingSegments& grown = segments[i];
    store(before.n, grown.n);
    store(before.t, grown.t);
    store(before.tt, grown.tt);
    store(before.rho, grown.rho);
    store(before.t_rho, grown.t_rho);
    store(before.rho_rho, grown.rho_rho);
    store(squared_error, grown.squared_error);
    store(tolerance2, grown.tolerance2);
    store(last, grown.last);
    const Words bit = Words{} + (std::uint64_t{1} << (i % kBits));
    bits |= __builtin_convertvector(is_valid & ~is_alike, Words) & bit;
    if (i % kBits == kBits - 1 || i + 1 == windows) {
      std::memcpy(starts[i / kBits].data(), &bits, sizeof bits);
      bits = Words{};
    }
  }
}

}  // namespace line_plane_segmentation
