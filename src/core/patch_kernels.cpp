// SPDX-License-Identifier: BSD-3-Clause
#include "patch_kernels.h"

#include <cstddef>
#include <cstring>

#include "multiversion.h"

namespace line_plane_segmentation {
namespace {

// Many numbers as one, with operators for each of them: left to itself the compiler makes sums in registers
// one by one.
constexpr int kBlock = 8;
using Floats = float __attribute__((vector_size(kBlock * sizeof(float))));
using Doubles = double __attribute__((vector_size(kBlock * sizeof(double))));

inline void load(const float* from, Doubles& numbers) {
  Floats floats;
  std::memcpy(&floats, from, sizeof floats);
  numbers = __builtin_convertvector(floats, Doubles);
}
inline void load(const float* from, double& number) { number = static_cast<double>(*from); }

template <typename Numbers>
inline void store(const Numbers& numbers, double* to) {
  std::memcpy(to, &numbers, sizeof numbers);
}

// Sums as many windows, from `first` on, as there are Numbers.
template <typename Numbers>
inline void sumWindows(const float* z, const float* t, int pixels, int windows, int first,
                       const WindowLanes& sums) {
  const Numbers zero = {}, one = zero + 1.0;
  Numbers n = zero, sum_t = zero, sum_tt = zero, sum_w = zero, sum_tw = zero, sum_ww = zero;
  for (std::ptrdiff_t k = 0; k < pixels; ++k) {
    Numbers depth, ray;
    load(z + k * windows + first, depth);
    load(t + k * windows + first, ray);
    const auto valid = depth > zero;
    ray = valid ? ray : zero;
    const Numbers w = valid ? one / depth : zero;
    n += valid ? one : zero;
    sum_t += ray;
    sum_tt += ray * ray;
    sum_w += w;
    sum_tw += ray * w;
    sum_ww += w * w;
  }
  store(n, sums.n + first);
  store(sum_t, sums.t + first);
  store(sum_tt, sums.tt + first);
  store(sum_w, sums.w + first);
  store(sum_tw, sums.tw + first);
  store(sum_ww, sums.ww + first);
}

}  // namespace

LPS_MULTIVERSION
void sumPixels(const float* z, const float* t, int pixels, int windows, const WindowLanes& sums) {
  int first = 0;
  for (; first + kBlock <= windows; first += kBlock) sumWindows<Doubles>(z, t, pixels, windows, first, sums);
  if (first == windows) return;
  // The last block lies over the one before, whose windows get the same sums again.
  if (windows >= kBlock) return sumWindows<Doubles>(z, t, pixels, windows, windows - kBlock, sums);
  for (; first < windows; ++first) sumWindows<double>(z, t, pixels, windows, first, sums);
}

LPS_MULTIVERSION
void fitCrossings(const WindowLanes& rows, const WindowLanes& columns, const float* x, double y, int count,
                  const CrossingBounds& bounds, CrossingFits& fits) {
  const WindowLanes row_windows = rows, column_windows = columns;
  const CrossingBounds bound = bounds;
  double *const xx = fits.row(kFitXx), *const xy = fits.row(kFitXy), *const yy = fits.row(kFitYy);
  double *const mx = fits.row(kFitX), *const my = fits.row(kFitY), *const one = fits.row(kFitOne);
  double *const xw = fits.row(kFitXw), *const yw = fits.row(kFitYw), *const mw = fits.row(kFitW);
  double *const ww = fits.row(kFitWw), *const pixels = fits.row(kFitPixels);
  double *const plane_a = fits.row(kFitA), *const plane_b = fits.row(kFitB), *const plane_c = fits.row(kFitC);
  double* const squared_errors = fits.row(kFitSquaredError);
  double *const straight_lines = fits.row(kFitLines), *const planar = fits.row(kFitPlanar);
  LPS_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const LineSums row = row_windows[i], column = column_windows[i];
    RegressionMoments moments = momentsOfCrossing(row, column, static_cast<double>(x[i]), y);
    InverseDepthPlane plane;
    double squared_error = 0.0;
    const bool is_plane = moments.fit(plane, squared_error);
    const bool is_fixed = is_plane & (row.n >= bound.min_points) & (column.n >= bound.min_points);
    const double tolerance = bound.tolerance.at(moments.w / moments.one, plane.inverseDistance());
    const double flat = bound.flatness * tolerance * tolerance;
    const bool row_is_straight = row.squaredErrorOfLine() < flat * row.n;
    const bool column_is_straight = column.squaredErrorOfLine() < flat * column.n;
    const double lines = (row_is_straight ? 1.0 : 0.0) + (column_is_straight ? 1.0 : 0.0);
    const bool is_planar =
        is_fixed & row_is_straight & column_is_straight & (squared_error < flat * moments.pixels);
    const double weight = 1.0 / (tolerance * tolerance);
    moments.scale(weight);
    xx[i] = moments.xx;
    xy[i] = moments.xy;
    yy[i] = moments.yy;
    mx[i] = moments.x;
    my[i] = moments.y;
    one[i] = moments.one;
    xw[i] = moments.xw;
    yw[i] = moments.yw;
    mw[i] = moments.w;
    ww[i] = moments.ww;
    pixels[i] = moments.pixels;
    plane_a[i] = plane.a;
    plane_b[i] = plane.b;
    plane_c[i] = plane.c;
    squared_errors[i] = squared_error * weight;
    straight_lines[i] = is_fixed ? lines : 0.0;
    planar[i] = is_planar ? 1.0 : 0.0;
  }
}

}  // namespace line_plane_segmentation
