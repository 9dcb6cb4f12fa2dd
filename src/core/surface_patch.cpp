// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/surface_patch.h"

#include <algorithm>
#include <numeric>

#include "patch_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr double kMinFilled = 0.7;  // share of a window's pixels that must have a depth
constexpr int kMinHalfWindow =
    2;  // [px] of a fine window: five points make a line and show whether it is one

int countAlong(int pixels, int spacing) {
  return pixels > spacing / 2 ? (pixels - 1 - spacing / 2) / spacing + 1 : 0;
}

// The numbers of a row between margins of zeros.
void widen(const float* row, std::size_t count, int margin, std::vector<float>& wide) {
  wide.assign(count + 2 * static_cast<std::size_t>(margin), 0.0F);
  std::copy_n(row, count, wide.begin() + margin);
}

// Puts the numbers at some places of a row next to each other.
float* gather(const float* row, const std::vector<int>& places, float* to) {
#pragma GCC unroll 4
  for (const int place : places) *to++ = row[place];
  return to;
}

// Lays an empty grid over an image.
void lay(const DepthImage& depth, int spacing, PatchGrid& grid) {
  grid.spacing = spacing;
  grid.columns = countAlong(depth.width, spacing);
  grid.rows = countAlong(depth.height, spacing);
  grid.patches.clear();
  grid.cells.clear();
  grid.patch_at.assign(static_cast<std::size_t>(grid.crossings()), -1);
  grid.has_line.assign(static_cast<std::size_t>(grid.crossings()), 0);
}

}  // namespace

void PatchGrid::spread(const std::vector<int>& of_patch, int first, std::vector<int>& of_crossing) const {
  of_crossing.assign(patch_at.size(), -1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    of_crossing[static_cast<std::size_t>(cells[i])] = of_patch[static_cast<std::size_t>(first) + i];
  }
}

// Chooses the crossings of the next rows, grid_columns_ being theirs.
void PatchDetector::chooseColumns(const PatchGrid& grid, int half_window) {
  columns_.clear();
  for (const int column : grid_columns_) columns_.push_back(grid.pixelOf(column));
  const std::size_t lanes = columns_.size();
  x_.resize(lanes);
  for (std::size_t i = 0; i < lanes; ++i)
    x_[i] = wide_x_[static_cast<std::size_t>(columns_[i] + half_window)];
  row_t_.resize(lanes * static_cast<std::size_t>(2 * half_window + 1));
  gatherWindows(wide_x_.data(), half_window, row_t_.data());
  fits_.resize(static_cast<int>(lanes));
  row_sums_.resize(static_cast<int>(lanes));
  column_sums_.resize(static_cast<int>(lanes));
}

// The numbers of a row in the windows around columns_, all first ones first.
void PatchDetector::gatherWindows(const float* wide_row, int half_window, float* to) const {
  for (int k = 0; k <= 2 * half_window; ++k) to = gather(wide_row + k, columns_, to);
}

// Sums the windows of the row's crossings. Pixels outside of the image are as without depth.
void PatchDetector::sumWindows(const DepthImage& depth, const ViewRays& rays, int v, int half_window) {
  const int lanes = static_cast<int>(columns_.size()), steps = 2 * half_window + 1;
  z_.resize(row_t_.size());
  t_.resize(row_t_.size());
  widen(depth.row(v), static_cast<std::size_t>(depth.width), half_window, wide_row_);
  gatherWindows(wide_row_.data(), half_window, z_.data());
  sumPixels(z_.data(), row_t_.data(), steps, lanes, lanesOf(row_sums_));

  float* z = z_.data();
  float* t = t_.data();
  for (int j = v - half_window; j <= v + half_window; ++j) {
    const bool is_inside = 0 <= j && j < depth.height;
    const float* const row = depth.row(is_inside ? j : v);
    z = is_inside ? gather(row, columns_, z) : std::fill_n(z, lanes, 0.0F);
    t = std::fill_n(t, lanes, rays.y[static_cast<std::size_t>(is_inside ? j : v)]);
  }
  sumPixels(z_.data(), t_.data(), steps, lanes, lanesOf(column_sums_));
}

// Fits planes to the windows of a row of crossings with the ray y.
void PatchDetector::fit(double y, int half_window, const Parameters& parameters) {
  const double min_points = kMinFilled * (2 * half_window + 1);
  const CrossingBounds bounds{DepthTolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                             parameters.patches.patch_distance},
                              parameters.patches.patch_flatness, min_points};
  fitCrossings(lanesOf(row_sums_), lanesOf(column_sums_), x_.data(), y, static_cast<int>(columns_.size()),
               bounds, fits_);
}

// Looks at the crossings of a row of the grid that have been chosen.
void PatchDetector::addRow(const DepthImage& depth, const ViewRays& rays, int row, int half_window,
                           const Parameters& parameters, PatchGrid& grid) {
  const int v = grid.pixelOf(row);
  const double y = rays.y[static_cast<std::size_t>(v)];
  sumWindows(depth, rays, v, half_window);
  fit(y, half_window, parameters);
  for (int lane = 0; lane < static_cast<int>(columns_.size()); ++lane) {
    const int cell = grid.indexOf(grid_columns_[static_cast<std::size_t>(lane)], row);
    grid.has_line[static_cast<std::size_t>(cell)] = fits_(kFitLines, lane) > 0.0 ? 1 : 0;
    if (!(fits_(kFitPlanar, lane) > 0.0)) continue;
    grid.patch_at[static_cast<std::size_t>(cell)] = static_cast<int>(grid.patches.size());
    grid.cells.push_back(cell);
    grid.patches.emplace_back(fits_, lane, columns_[static_cast<std::size_t>(lane)], v);
  }
}

void PatchDetector::detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                           PatchGrid& grid) {
  lay(depth, parameters.scanlines.scanline_spacing, grid);
  const int half_window = parameters.lines.line_window / 2;
  grid_columns_.resize(static_cast<std::size_t>(grid.columns));
  std::iota(grid_columns_.begin(), grid_columns_.end(), 0);
  widen(rays.x.data(), rays.x.size(), half_window, wide_x_);
  chooseColumns(grid, half_window);
  for (int r = 0; r < grid.rows; ++r) addRow(depth, rays, r, half_window, parameters, grid);
}

void PatchDetector::refine(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                           const std::vector<std::uint8_t>& explained, PatchLevels& levels) {
  const PatchGrid& coarse = levels.coarse;
  PatchGrid& fine = levels.fine;
  lay(depth, parameters.scanlines.fine_spacing, fine);
  // An image smaller than a tile has no coarse crossing that could ask for more.
  if (fine.spacing >= coarse.spacing || coarse.crossings() == 0) return;

  levels.tile_columns.clear();
  levels.tile_rows.clear();
  for (int c = -1; c <= fine.columns; ++c) levels.tile_columns.push_back(coarse.indexAt(fine.pixelOf(c), 0));
  for (int r = -1; r <= fine.rows; ++r)
    levels.tile_rows.push_back(coarse.indexAt(0, fine.pixelOf(r)) / coarse.columns);
  const int half_window =
      std::max(kMinHalfWindow, parameters.lines.line_window * fine.spacing / coarse.spacing / 2);
  widen(rays.x.data(), rays.x.size(), half_window, wide_x_);
  for (int r = 0; r < fine.rows; ++r) {
    grid_columns_.clear();
    for (int c = 0; c < fine.columns; ++c) {
      const std::size_t tile =
          static_cast<std::size_t>(coarse.indexOf(levels.tileColumn(c), levels.tileRow(r)));
      if (explained[tile] == 0 && coarse.has_line[tile] != 0) grid_columns_.push_back(c);
    }
    if (grid_columns_.empty()) continue;
    chooseColumns(fine, half_window);
    addRow(depth, rays, r, half_window, parameters, fine);
  }
}

}  // namespace line_plane_segmentation
