// SPDX-License-Identifier: BSD-3-Clause
#include "planes/crossing_candidates.h"

#include <algorithm>
#include <cmath>

#include "kernels/sparing_growth.h"

namespace line_plane_segmentation {
namespace {

// The windows of the segment `id` at and beside a window of a scanline.
LineSums sumAround(const ScanlineSet& set, int scanline, int window, int id) {
  LineSums sums;
  for (int i = std::max(0, window - 1); i <= std::min(set.windows - 1, window + 1); ++i) {
    const std::size_t index = set.indexOf(scanline, i);
    if (set.segment_of[index] == id) sums = sums + set.sums[index];
  }
  return sums;
}

// The moments of the pixels of a row and of a column, which cross at the ray (x, y).
RegressionMoments momentsOf(const LineSums& row, const LineSums& column, double x, double y) {
  const double n = row.n + column.n;
  return {row.tt + x * x * column.n,
          y * row.t + x * column.t,
          y * y * row.n + column.tt,
          row.t + x * column.n,
          y * row.n + column.t,
          n,
          row.t_rho + x * column.rho,
          y * row.rho + column.t_rho,
          row.rho + column.rho,
          row.rho_rho + column.rho_rho,
          n};
}

// Fits the plane of the moments, and weighs them by 1 / tolerance².
// @return false if they are degenerate or not flat
bool fitWithin(const DepthTolerance& tolerance, double max_flatness, CrossingCandidate& candidate) {
  RegressionMoments& m = candidate.moments;
  if (!m.fit(candidate.plane, candidate.squared_error)) return false;
  const double inv = 1.0 / m.pixels;
  candidate.x = m.x * inv;
  candidate.y = m.y * inv;
  candidate.rho = m.rho * inv;
  const InverseDepthPlane& p = candidate.plane;
  const double inverse_distance2 = p.a * p.a + p.b * p.b + p.c * p.c;
  const double weight = 1.0 / tolerance.squaredAt(candidate.rho, inverse_distance2);
  candidate.inv_tolerance = std::sqrt(weight);
  candidate.squared_error *= weight;
  if (!(candidate.squared_error < max_flatness * m.pixels)) return false;
  m.scale(weight);
  return true;
}

// The variance across the plane over the variance in all directions, as the eigenvalues of the pixels' points
// give it, to first order about their mean. An error e of the inverse depth is a distance of e d / rho to the
// plane.
double curvatureOf(const CrossingCandidate& candidate) {
  const RegressionMoments& m = candidate.moments;
  const InverseDepthPlane& plane = candidate.plane;
  const double inv = 1.0 / m.weight, x = candidate.x, y = candidate.y, z = 1.0 / candidate.rho;
  const double xx = m.xx * inv - x * x, xy = m.xy * inv - x * y, yy = m.yy * inv - y * y;
  // The point at the ray (x, y) is z (x, y, 1): its derivatives by x and y, as z changes by -a z² and -b z².
  const Eigen::Vector3d ray(x, y, 1.0);
  const Eigen::Vector3d by_x = z * Eigen::Vector3d::UnitX() - plane.a * z * z * ray;
  const Eigen::Vector3d by_y = z * Eigen::Vector3d::UnitY() - plane.b * z * z * ray;
  const double along = by_x.squaredNorm() * xx + 2.0 * by_x.dot(by_y) * xy + by_y.squaredNorm() * yy;
  const double distance = z / plane.inverseDistance();
  const double across = candidate.squared_error * inv * distance * distance;
  return std::min(across / (across + along), 1.0 / 3.0);  // the first order knows no upper bound
}

// Fits the candidate where row r and column c of the grid cross.
// @return false if the segments are not coplanar there
bool fitAtCrossing(const ViewRays& rays, const ScanlineSet& rows, const ScanlineSet& columns, int r, int c,
                   const DepthTolerance& tolerance, double max_flatness, CrossingCandidate& candidate) {
  const int u = columns.pixels[c], v = rows.pixels[r];
  const int row_window = rows.windowAt(u), column_window = columns.windowAt(v);
  const LineSums row = sumAround(rows, r, row_window, rows.segment_of[rows.indexOf(r, row_window)]);
  const LineSums column =
      sumAround(columns, c, column_window, columns.segment_of[columns.indexOf(c, column_window)]);
  candidate.moments = momentsOf(row, column, static_cast<double>(rays.x[u]), static_cast<double>(rays.y[v]));
  candidate.u = u;
  candidate.v = v;
  return fitWithin(tolerance, max_flatness, candidate);
}

}  // namespace

PlaneCandidate CrossingCandidate::describe() const {
  PlaneCandidate candidate;
  candidate.u = u;
  candidate.v = v;
  candidate.d = 1.0 / plane.inverseDistance();
  candidate.normal = -candidate.d * Eigen::Vector3d(plane.a, plane.b, plane.c);
  candidate.curvature = curvatureOf(*this);
  return candidate;
}

void CrossingDetector::detect(const ViewRays& rays, const ScanlineSet& rows, const ScanlineSet& columns,
                              const Parameters& parameters, CandidateGrid& grid) {
  grid.spacing = parameters.scanlines.scanline_spacing;
  grid.columns = columns.count();
  grid.rows = rows.count();
  grid.candidates.clear();
  grid.links.clear();
  grid.candidate_at.assign(static_cast<std::size_t>(grid.crossings()), -1);
  const DepthTolerance tolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                 parameters.patches.patch_distance};
  CrossingCandidate candidate;  // each value is set anew: to start from zeros would take long
  for (int r = 0; r < grid.rows; ++r) {
    const int v = rows.pixels[r];
    int left = -1, left_segment = -1;  // the candidate before, and its row segment
    for (int c = 0; c < grid.columns; ++c) {
      const int u = columns.pixels[c];
      const int row_segment = rows.segment_of[rows.indexOf(r, rows.windowAt(u))];
      const int column_segment = columns.segment_of[columns.indexOf(c, columns.windowAt(v))];
      const int before = left;
      left = -1;
      if (row_segment < 0 || column_segment < 0) continue;
      if (!fitAtCrossing(rays, rows, columns, r, c, tolerance, parameters.patches.patch_flatness, candidate))
        continue;
      candidate.cell = grid.indexOf(c, r);
      const int index = static_cast<int>(grid.candidates.size());
      reserveSparingly(grid.candidates.size() + 1, grid.candidates);
      grid.candidates.push_back(candidate);
      grid.candidate_at[candidate.cell] = index;
      if (before >= 0 && left_segment == row_segment) grid.links.push_back({before, index});
      left = index;
      left_segment = row_segment;
      if (r == 0) continue;
      const int above = grid.candidate_at[candidate.cell - grid.columns];
      const int window_above = columns.windowAt(rows.pixels[r - 1]);
      if (above >= 0 && columns.segment_of[columns.indexOf(c, window_above)] == column_segment)
        grid.links.push_back({above, index});
    }
  }
}

}  // namespace line_plane_segmentation
