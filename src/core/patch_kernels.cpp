// SPDX-License-Identifier: BSD-3-Clause
#include "patch_kernels.h"

#include "multiversion.h"

namespace line_plane_segmentation {
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

LPS_MULTIVERSION
void fitCrossings(const WindowLanes& rows, const WindowLanes& columns, const float* x, double y, int count,
                  const CrossingBounds& bounds, CrossingFits& fits) {
  const WindowLanes row_windows = rows, column_windows = columns;
  const CrossingBounds bound = bounds;
  double *const plane_a = fits.row(kFitA), *const plane_b = fits.row(kFitB), *const plane_c = fits.row(kFitC);
  double *const squared_errors = fits.row(kFitSquaredError), *const tolerances = fits.row(kFitTolerance);
  double *const straight_lines = fits.row(kFitLines), *const planar = fits.row(kFitPlanar);
  LPS_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const LineSums row = row_windows[i], column = column_windows[i];
    const RegressionMoments moments = momentsOfCrossing(row, column, static_cast<double>(x[i]), y);
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
    plane_a[i] = plane.a;
    plane_b[i] = plane.b;
    plane_c[i] = plane.c;
    squared_errors[i] = squared_error;
    tolerances[i] = tolerance;
    straight_lines[i] = is_fixed ? lines : 0.0;
    planar[i] = is_planar ? 1.0 : 0.0;
  }
}

}  // namespace line_plane_segmentation
