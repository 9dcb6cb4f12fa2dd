// SPDX-License-Identifier: BSD-3-Clause
#include "patch_kernels.h"

#include <cmath>

#include "multiversion.h"

namespace line_plane_segmentation {
namespace {

inline double larger(double a, double b) { return a > b ? a : b; }

/// The squared error of the line through a window's pixels, their spreads about the mean being given. Of no
/// meaning if they have one t only, and then not asked: such windows fix no plane.
inline double squaredErrorOfLine(double ctt, double ctw, double cww) { return cww - ctw * ctw / ctt; }

}  // namespace

LPS_MULTIVERSION
void addPixels(const float* z, const float* t, int count, const WindowLanes& sums) {
  const WindowLanes s = sums;
  LPS_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const bool valid = z[i] > 0.0F;
    const double ray = valid ? static_cast<double>(t[i]) : 0.0;
    const double w = valid ? 1.0 / static_cast<double>(z[i]) : 0.0;
    s.n[i] += valid ? 1.0 : 0.0;
    s.t[i] += ray;
    s.tt[i] += ray * ray;
    s.w[i] += w;
    s.tw[i] += ray * w;
    s.ww[i] += w * w;
  }
}

// The same sums as RegressionMoments', about the mean as in its fit().
LPS_MULTIVERSION
void fitCrossings(const WindowLanes& rows, const WindowLanes& columns, const float* x, double y, int count,
                  const CrossingBounds& bounds, CrossingFits& fits) {
  const WindowLanes r = rows, k = columns;
  const CrossingBounds bound = bounds;
  double *const plane_a = fits.row(kFitA), *const plane_b = fits.row(kFitB), *const plane_c = fits.row(kFitC);
  double *const squared_errors = fits.row(kFitSquaredError), *const tolerances = fits.row(kFitTolerance);
  double *const straight_lines = fits.row(kFitLines), *const planar = fits.row(kFitPlanar);
  LPS_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const double u = static_cast<double>(x[i]);
    const double share_r = 1.0 / r.n[i], share_k = 1.0 / k.n[i], pixels = r.n[i] + k.n[i];
    const double share = 1.0 / pixels;
    const double ctt_r = r.tt[i] - r.t[i] * r.t[i] * share_r, ctw_r = r.tw[i] - r.t[i] * r.w[i] * share_r;
    const double cww_r = r.ww[i] - r.w[i] * r.w[i] * share_r;
    const double ctt_k = k.tt[i] - k.t[i] * k.t[i] * share_k, ctw_k = k.tw[i] - k.t[i] * k.w[i] * share_k;
    const double cww_k = k.ww[i] - k.w[i] * k.w[i] * share_k;

    const double sum_x = r.t[i] + u * k.n[i], sum_y = y * r.n[i] + k.t[i], sum_w = r.w[i] + k.w[i];
    const double x_mean = sum_x * share, y_mean = sum_y * share, w_mean = sum_w * share;
    const double cxx = r.tt[i] + u * u * k.n[i] - sum_x * x_mean;
    const double cxy = y * r.t[i] + u * k.t[i] - sum_x * y_mean;
    const double cyy = y * y * r.n[i] + k.tt[i] - sum_y * y_mean;
    const double cxw = r.tw[i] + u * k.w[i] - sum_x * w_mean;
    const double cyw = y * r.w[i] + k.tw[i] - sum_y * w_mean;
    const double cww = r.ww[i] + k.ww[i] - sum_w * w_mean;
    const double determinant = cxx * cyy - cxy * cxy, inverse = 1.0 / determinant;
    const double a = (cyy * cxw - cxy * cyw) * inverse, b = (cxx * cyw - cxy * cxw) * inverse;
    const double c = w_mean - a * x_mean - b * y_mean;
    const double squared_error = larger(0.0, cww - a * cxw - b * cyw);

    // DepthTolerance::at().
    const double reach = 1.0 - bound.tolerance.noise.nearest * w_mean;
    const double along = bound.tolerance.noise_factor * (bound.tolerance.noise.floor * w_mean * w_mean +
                                                         bound.tolerance.noise.growth * reach * reach);
    const double across = bound.tolerance.distance * w_mean * std::sqrt(a * a + b * b + c * c);
    const double tolerance = larger(along, across);
    const double flat = bound.flatness * tolerance * tolerance;
    const bool is_fixed =
        (r.n[i] >= bound.min_points) & (k.n[i] >= bound.min_points) & (determinant > 1e-9 * cxx * cyy);
    const bool row_is_straight = squaredErrorOfLine(ctt_r, ctw_r, cww_r) < flat * r.n[i];
    const bool column_is_straight = squaredErrorOfLine(ctt_k, ctw_k, cww_k) < flat * k.n[i];
    const double lines = (row_is_straight ? 1.0 : 0.0) + (column_is_straight ? 1.0 : 0.0);
    plane_a[i] = a;
    plane_b[i] = b;
    plane_c[i] = c;
    squared_errors[i] = squared_error;
    tolerances[i] = tolerance;
    straight_lines[i] = is_fixed ? lines : 0.0;
    planar[i] = (is_fixed & (lines > 1.5) & (squared_error < flat * pixels)) ? 1.0 : 0.0;
  }
}

}  // namespace line_plane_segmentation
