// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/surface_patch.h"

#include <algorithm>

#include "patch_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr double kMinFilled = 0.7;  // share of a window's pixels that must have a depth
constexpr int kMinHalfWindow =
    2;  // [px] of a fine window: five points make a line and show whether it is one

int countAlong(int pixels, int spacing) {
  return pixels > spacing / 2 ? (pixels - 1 - spacing / 2) / spacing + 1 : 0;
}

}  // namespace

// The window of each scanline around each crossing, all parallel scanlines at once: what has been summed
// along the scanlines before a window's first pixel is put away, and subtracted behind its last.
// @param rays     ray coordinates along the scanlines, one for each step
// @param depthAt  the depth on a line at a step
// @param cell     of a line and a window of it, the crossing
template <typename DepthAt, typename Cell>
void PatchDetector::sumWindows(const PatchGrid& grid, int lines, int windows, const std::vector<float>& rays,
                               int half_window, DepthAt&& depthAt, Cell&& cell, WindowSums& sums) {
  const int steps = static_cast<int>(rays.size());
  resetLanes(lines);
  running_.setZero(lines);
  int opening = 0, closing = 0;  // the next windows to begin and to end
  for (int step = 0; step <= steps; ++step) {
    while (opening < windows && std::max(0, grid.pixelOf(opening) - half_window) == step) {
      for (int line = 0; line < lines; ++line) sums.lane(cell(line, opening)) = running_.lane(line);
      ++opening;
    }
    while (closing < windows && std::min(steps, grid.pixelOf(closing) + half_window + 1) == step) {
      for (int line = 0; line < lines; ++line) {
        auto sum = sums.lane(cell(line, closing));
        sum = running_.lane(line) - sum;
      }
      ++closing;
    }
    if (step == steps) break;
    for (int line = 0; line < lines; ++line) z_[static_cast<std::size_t>(line)] = depthAt(line, step);
    std::fill(t_.begin(), t_.end(), rays[static_cast<std::size_t>(step)]);
    addPixels(z_.data(), t_.data(), lines, lanesFrom(0, running_));
  }
}

void PatchDetector::resetLanes(int lanes) {
  const std::size_t count = static_cast<std::size_t>(lanes);
  z_.resize(count);
  t_.resize(count);
}

// Fits the crossings of `count` windows, from one on, with those of x_; they lie in an image row with ray y.
void PatchDetector::fit(int first, int count, double y, double min_points, const Parameters& parameters) {
  const CrossingBounds bounds{DepthTolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                             parameters.patches.patch_distance},
                              parameters.patches.patch_flatness, min_points};
  fitCrossings(lanesFrom(first, row_sums_), lanesFrom(first, column_sums_), x_.data(), y, count, bounds,
               fits_);
}

// The patch of a crossing that has been fitted.
SurfacePatch PatchDetector::patchOf(int crossing, int lane, double y) {
  SurfacePatch patch;
  patch.has_line = fits_(kFitLines, lane) > 0.0;
  patch.is_planar = fits_(kFitPlanar, lane) > 0.0;
  if (!patch.is_planar) return patch;
  patch.plane = {fits_(kFitA, lane), fits_(kFitB, lane), fits_(kFitC, lane)};
  const double weight = 1.0 / (fits_(kFitTolerance, lane) * fits_(kFitTolerance, lane));
  patch.squared_error = fits_(kFitSquaredError, lane) * weight;
  patch.moments = momentsOfCrossing(lanesFrom(crossing, row_sums_)[0], lanesFrom(crossing, column_sums_)[0],
                                    static_cast<double>(x_[static_cast<std::size_t>(lane)]), y);
  patch.moments.scale(weight);
  return patch;
}

void PatchDetector::detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                           PatchGrid& grid) {
  grid.spacing = parameters.scanlines.scanline_spacing;
  grid.columns = countAlong(depth.width, grid.spacing);
  grid.rows = countAlong(depth.height, grid.spacing);
  const int count = grid.columns * grid.rows;
  const int half_window = parameters.lines.line_window / 2;
  row_sums_.resize(count);
  column_sums_.resize(count);
  sumWindows(
      grid, grid.rows, grid.columns, rays.x, half_window,
      [&](int r, int u) { return depth.at(u, grid.pixelOf(r)); },
      [&](int r, int c) { return grid.indexOf(c, r); }, row_sums_);
  sumWindows(
      grid, grid.columns, grid.rows, rays.y, half_window,
      [&](int c, int v) { return depth.at(grid.pixelOf(c), v); },
      [&](int c, int r) { return grid.indexOf(c, r); }, column_sums_);

  const double min_points = kMinFilled * (2 * half_window + 1);
  x_.resize(static_cast<std::size_t>(grid.columns));
  fits_.resize(grid.columns);
  for (int c = 0; c < grid.columns; ++c)
    x_[static_cast<std::size_t>(c)] = rays.x[static_cast<std::size_t>(grid.pixelOf(c))];
  grid.patches.clear();
  grid.patches.reserve(static_cast<std::size_t>(count));
  for (int r = 0; r < grid.rows; ++r) {
    const double y = rays.y[static_cast<std::size_t>(grid.pixelOf(r))];
    fit(grid.indexOf(0, r), grid.columns, y, min_points, parameters);
    for (int c = 0; c < grid.columns; ++c) grid.patches.push_back(patchOf(grid.indexOf(c, r), c, y));
  }
}

// The windows of the crossings of a row of the fine grid, its columns being in fine_columns_.
void PatchDetector::sumFineRow(const DepthImage& depth, const ViewRays& rays, const FinePatches& fine, int v,
                               int half_window) {
  const std::size_t lanes = fine_columns_.size();
  row_sums_.setZero(static_cast<int>(lanes));
  column_sums_.setZero(static_cast<int>(lanes));
  const float* z = depth.row(v);
  for (int k = -half_window; k <= half_window; ++k) {
    for (std::size_t i = 0; i < lanes; ++i) {
      const int u = fine.pixelOf(fine_columns_[i]) + k;
      const bool is_inside = 0 <= u && u < depth.width;
      z_[i] = is_inside ? z[u] : 0.0F;
      t_[i] = is_inside ? rays.x[static_cast<std::size_t>(u)] : 0.0F;
    }
    addPixels(z_.data(), t_.data(), static_cast<int>(lanes), lanesFrom(0, row_sums_));
  }
  for (int j = std::max(0, v - half_window); j < std::min(depth.height, v + half_window + 1); ++j) {
    for (std::size_t i = 0; i < lanes; ++i) z_[i] = depth.at(fine.pixelOf(fine_columns_[i]), j);
    std::fill(t_.begin(), t_.end(), rays.y[static_cast<std::size_t>(j)]);
    addPixels(z_.data(), t_.data(), static_cast<int>(lanes), lanesFrom(0, column_sums_));
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
    fine_columns_.clear();
    for (int c = 0; c < fine.columns; ++c) {
      const std::size_t tile = static_cast<std::size_t>(coarse.indexAt(fine.pixelOf(c), v));
      if (explained[tile] == 0 && coarse.patches[tile].has_line) fine_columns_.push_back(c);
    }
    if (fine_columns_.empty()) continue;
    const int lanes = static_cast<int>(fine_columns_.size());
    resetLanes(lanes);
    x_.resize(fine_columns_.size());
    fits_.resize(lanes);
    for (int i = 0; i < lanes; ++i)
      x_[static_cast<std::size_t>(i)] =
          rays.x[static_cast<std::size_t>(fine.pixelOf(fine_columns_[static_cast<std::size_t>(i)]))];
    sumFineRow(depth, rays, fine, v, half_window);
    const double y = rays.y[static_cast<std::size_t>(v)];
    fit(0, lanes, y, min_points, parameters);
    for (int i = 0; i < lanes; ++i) {
      if (!(fits_(kFitPlanar, i) > 0.0)) continue;
      const int cell = r * fine.columns + fine_columns_[static_cast<std::size_t>(i)];
      fine.patch_at[static_cast<std::size_t>(cell)] = static_cast<int>(fine.patches.size());
      fine.cells.push_back(cell);
      fine.patches.push_back(patchOf(i, i, y));
    }
  }
}

}  // namespace line_plane_segmentation
