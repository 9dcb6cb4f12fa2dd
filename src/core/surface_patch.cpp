// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/surface_patch.h"

#include <algorithm>
#include <limits>

namespace line_plane_segmentation {
namespace {

constexpr double kMinFilled = 0.7;  // share of a window's pixels that must have a depth
constexpr int kMinHalfWindow =
    2;  // [px] of a fine window: five points make a line and show whether it is one

int countAlong(int pixels, int spacing) {
  return pixels > spacing / 2 ? (pixels - 1 - spacing / 2) / spacing + 1 : 0;
}

template <typename Sums>
void addPixel(float z, double t, Sums& sums) {
  if (!(z > 0.0F)) return;
  const double w = 1.0 / static_cast<double>(z);
  sums.n += 1.0;
  sums.t += t;
  sums.tt += t * t;
  sums.w += w;
  sums.tw += t * w;
  sums.ww += w * w;
}

}  // namespace

double PatchDetector::LineSums::squaredErrorOfLine() const {
  const double ctt = tt - t * t / n, ctw = tw - t * w / n, cww = ww - w * w / n;
  return ctt > 0.0 ? std::max(0.0, cww - ctw * ctw / ctt) : std::numeric_limits<double>::max();
}

void PatchDetector::sumRows(const DepthImage& depth, const ViewRays& rays, int half_window,
                            const PatchGrid& grid) {
  running_.resize(static_cast<std::size_t>(depth.width) + 1);
  for (int r = 0; r < grid.rows; ++r) {
    const float* z = depth.row(grid.pixelOf(r));
    LineSums sums;
    running_[0] = sums;
    for (int u = 0; u < depth.width; ++u) {
      addPixel(z[u], rays.x[static_cast<std::size_t>(u)], sums);
      running_[static_cast<std::size_t>(u) + 1] = sums;
    }
    for (int c = 0; c < grid.columns; ++c) {
      const int first = std::max(0, grid.pixelOf(c) - half_window);
      const int end = std::min(depth.width, grid.pixelOf(c) + half_window + 1);
      row_windows_[static_cast<std::size_t>(grid.indexOf(c, r))] =
          running_[static_cast<std::size_t>(end)] - running_[static_cast<std::size_t>(first)];
    }
  }
}

// All columns at once from the top down, so that the image is read row by row: what has been summed above a
// window's first row is put away, and subtracted at its end.
void PatchDetector::sumColumns(const DepthImage& depth, const ViewRays& rays, int half_window,
                               const PatchGrid& grid) {
  running_.assign(static_cast<std::size_t>(grid.columns), LineSums{});
  int opening = 0, closing = 0;  // the next rows of the grid whose windows begin and end
  for (int v = 0; v <= depth.height; ++v) {
    while (opening < grid.rows && std::max(0, grid.pixelOf(opening) - half_window) == v) {
      std::copy(running_.begin(), running_.end(), column_windows_.begin() + grid.indexOf(0, opening));
      ++opening;
    }
    while (closing < grid.rows && std::min(depth.height, grid.pixelOf(closing) + half_window + 1) == v) {
      LineSums* windows = column_windows_.data() + grid.indexOf(0, closing);
      for (int c = 0; c < grid.columns; ++c) windows[c] = running_[static_cast<std::size_t>(c)] - windows[c];
      ++closing;
    }
    if (v == depth.height) break;
    const float* z = depth.row(v);
    const double y = rays.y[static_cast<std::size_t>(v)];
    for (int c = 0; c < grid.columns; ++c)
      addPixel(z[grid.pixelOf(c)], y, running_[static_cast<std::size_t>(c)]);
  }
}

PatchDetector::LineSums PatchDetector::sumRow(const DepthImage& depth, const ViewRays& rays, int u, int v,
                                              int half_window) {
  LineSums sums;
  const float* z = depth.row(v);
  for (int i = std::max(0, u - half_window); i < std::min(depth.width, u + half_window + 1); ++i)
    addPixel(z[i], rays.x[static_cast<std::size_t>(i)], sums);
  return sums;
}

PatchDetector::LineSums PatchDetector::sumColumn(const DepthImage& depth, const ViewRays& rays, int u, int v,
                                                 int half_window) {
  LineSums sums;
  for (int i = std::max(0, v - half_window); i < std::min(depth.height, v + half_window + 1); ++i)
    addPixel(depth.at(u, i), rays.y[static_cast<std::size_t>(i)], sums);
  return sums;
}

void PatchDetector::fitCrossing(const LineSums& row, const LineSums& column, double x, double y,
                                const Parameters& parameters, SurfacePatch& patch) {
  RegressionMoments& m = patch.moments;
  m.xx = row.tt + x * x * column.n;
  m.xy = y * row.t + x * column.t;
  m.yy = y * y * row.n + column.tt;
  m.x = row.t + x * column.n;
  m.y = y * row.n + column.t;
  m.one = m.pixels = row.n + column.n;
  m.xw = row.tw + x * column.w;
  m.yw = y * row.w + column.tw;
  m.w = row.w + column.w;
  m.ww = row.ww + column.ww;
  const double squared_error = m.fit(patch.plane);
  if (squared_error < 0.0) return;

  const DepthTolerance tolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                 parameters.patches.patch_distance};
  const double bound = tolerance.at(m.w / m.one, patch.plane.inverseDistance());
  const double flat = parameters.patches.patch_flatness * bound * bound;
  const bool row_is_straight = row.squaredErrorOfLine() < flat * row.n;
  const bool column_is_straight = column.squaredErrorOfLine() < flat * column.n;
  patch.has_line = row_is_straight || column_is_straight;
  patch.is_planar = row_is_straight && column_is_straight && squared_error < flat * m.pixels;
  if (!patch.is_planar) return;
  patch.moments.scale(1.0 / (bound * bound));
  patch.squared_error = squared_error / (bound * bound);
}

void PatchDetector::detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                           PatchGrid& grid) {
  grid.spacing = parameters.scanlines.scanline_spacing;
  grid.columns = countAlong(depth.width, grid.spacing);
  grid.rows = countAlong(depth.height, grid.spacing);
  const std::size_t count = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  row_windows_.resize(count);
  column_windows_.resize(count);
  const int half_window = parameters.lines.line_window / 2;
  sumRows(depth, rays, half_window, grid);
  sumColumns(depth, rays, half_window, grid);

  const double min_points = kMinFilled * (2 * half_window + 1);
  grid.patches.assign(count, SurfacePatch{});
  for (int r = 0; r < grid.rows; ++r) {
    const double y = rays.y[static_cast<std::size_t>(grid.pixelOf(r))];
    for (int c = 0; c < grid.columns; ++c) {
      const std::size_t i = static_cast<std::size_t>(grid.indexOf(c, r));
      if (row_windows_[i].n < min_points || column_windows_[i].n < min_points) continue;
      fitCrossing(row_windows_[i], column_windows_[i], rays.x[static_cast<std::size_t>(grid.pixelOf(c))], y,
                  parameters, grid.patches[i]);
    }
  }
}

void PatchDetector::refine(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                           const std::vector<std::uint8_t>& explained, PatchLevels& levels) {
  const PatchGrid& coarse = levels.coarse;
  FinePatches& fine = levels.fine;
  fine.spacing = parameters.scanlines.fine_spacing;
  fine.columns = countAlong(depth.width, fine.spacing);
  fine.rows = countAlong(depth.height, fine.spacing);
  fine.patches.clear();
  fine.cells.clear();
  fine.patch_at.assign(static_cast<std::size_t>(fine.columns) * static_cast<std::size_t>(fine.rows), -1);
  // An image smaller than a tile has no coarse patch that could ask for more.
  if (fine.spacing >= coarse.spacing || coarse.patches.empty()) return;

  const int half_window =
      std::max(kMinHalfWindow, parameters.lines.line_window * fine.spacing / coarse.spacing / 2);
  const double min_points = kMinFilled * (2 * half_window + 1);
  for (int r = 0; r < fine.rows; ++r) {
    const int v = fine.pixelOf(r);
    for (int c = 0; c < fine.columns; ++c) {
      const int u = fine.pixelOf(c);
      const std::size_t tile = static_cast<std::size_t>(coarse.indexAt(u, v));
      if (explained[tile] != 0 || !coarse.patches[tile].has_line) continue;
      const LineSums row = sumRow(depth, rays, u, v, half_window);
      const LineSums column = sumColumn(depth, rays, u, v, half_window);
      if (row.n < min_points || column.n < min_points) continue;
      SurfacePatch patch;
      fitCrossing(row, column, rays.x[static_cast<std::size_t>(u)], rays.y[static_cast<std::size_t>(v)],
                  parameters, patch);
      if (!patch.is_planar) continue;
      const int cell = r * fine.columns + c;
      fine.patch_at[static_cast<std::size_t>(cell)] = static_cast<int>(fine.patches.size());
      fine.cells.push_back(cell);
      fine.patches.push_back(patch);
    }
  }
}

}  // namespace line_plane_segmentation
