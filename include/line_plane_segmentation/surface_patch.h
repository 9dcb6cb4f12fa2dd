// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/inverse_depth_plane.h"
#include "line_plane_segmentation/line_segment.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_candidate.h"
#include "line_plane_segmentation/window_sums.h"

namespace line_plane_segmentation {

/// The local plane where a row and a column cross, held up by two straight line primitives: the windows of
/// the two scanlines around the crossing.
struct SurfacePatch {
  bool has_line = false;   ///< one of the windows is straight, at least
  bool is_planar = false;  ///< both windows are straight and lie in one plane; if not, nothing below is set
  RegressionMoments moments;
  InverseDepthPlane plane;
  double squared_error = 0.0;  ///< of the pixels to the plane, in units of the tolerance squared
};

/// The crossings of all scanlines, row by row.
struct PatchGrid {
  int spacing = 1;  ///< [px] between scanlines
  int columns = 0, rows = 0;
  std::vector<SurfacePatch> patches;

  /// The image row through the patches of a row of the grid; the same for columns.
  int pixelOf(int index) const { return spacing / 2 + index * spacing; }
  int indexOf(int column, int row) const { return row * columns + column; }

  /// The patch nearest to a pixel: of the tile, `spacing` pixels wide, that it lies in.
  int indexAt(int u, int v) const {
    const int column = std::clamp(u / spacing, 0, columns - 1), row = std::clamp(v / spacing, 0, rows - 1);
    return indexOf(column, row);
  }
};

/// Planar patches of some crossings of finer scanlines.
struct FinePatches {
  int spacing = 1;  ///< [px] between scanlines
  int columns = 0, rows = 0;
  std::vector<SurfacePatch> patches;
  std::vector<int> cells;     ///< of each patch the number of its crossing, row by row
  std::vector<int> patch_at;  ///< of each crossing its patch, or -1
  /// The column and the row of the coarse grid that the fine grid's columns and rows -1, 0, 1, ... lie in,
  /// one more at either side than there are.
  std::vector<int> tile_columns, tile_rows;

  int tileColumn(int column) const { return tile_columns[static_cast<std::size_t>(column + 1)]; }
  int tileRow(int row) const { return tile_rows[static_cast<std::size_t>(row + 1)]; }
  int pixelOf(int index) const { return spacing / 2 + index * spacing; }
  double shareOfPicture() const { return 1.0 / std::max(1.0, static_cast<double>(columns) * rows); }
  /// -1 also above the first row.
  int patchAt(int cell) const { return cell < 0 ? -1 : patch_at[static_cast<std::size_t>(cell)]; }
};

/// All patches of an image: those of the scanlines, and of finer ones where there are lines that no plane
/// explains. They are numbered through, first all crossings of the coarse ones, then the fine patches.
struct PatchLevels {
  PatchGrid coarse;
  FinePatches fine;

  int firstFine() const { return static_cast<int>(coarse.patches.size()); }
  int count() const { return firstFine() + static_cast<int>(fine.patches.size()); }
  const SurfacePatch& patch(int i) const {
    return i < firstFine() ? coarse.patches[static_cast<std::size_t>(i)]
                           : fine.patches[static_cast<std::size_t>(i - firstFine())];
  }
  int u(int i) const {
    return i < firstFine() ? coarse.pixelOf(i % coarse.columns) : fine.pixelOf(cellOf(i) % fine.columns);
  }
  int v(int i) const {
    return i < firstFine() ? coarse.pixelOf(i / coarse.columns) : fine.pixelOf(cellOf(i) / fine.columns);
  }

 private:
  int cellOf(int i) const { return fine.cells[static_cast<std::size_t>(i - firstFine())]; }
};

/// Stages 1 to 3 of the adaptive method. A window of a scanline is fitted by linear regression in inverse
/// depth, where the scan of a plane is a straight line too.
class PatchDetector {
 public:
  /// @param parameters  resolved for the width of the image
  void detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters, PatchGrid& grid);

  /// Looks more closely, with shorter windows, where there are lines that no plane explains.
  /// @param explained  for each patch of levels.coarse whether it needs no closer look
  /// @param levels     levels.fine is filled; it is empty if the parameters want nothing finer
  void refine(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
              const std::vector<std::uint8_t>& explained, PatchLevels& levels);

 private:
  void chooseColumns(const ViewRays& rays, int half_window);
  void sumWindows(const DepthImage& depth, const ViewRays& rays, int v, int half_window);
  void fit(double y, int half_window, const Parameters& parameters);
  SurfacePatch patchOf(int lane, double y);

  // Of a row of crossings, one lane a crossing: the image's columns they lie in and the rays there, the sums
  // of their windows, and what is fitted to these.
  std::vector<int> columns_;
  std::vector<float> x_;
  WindowSums row_sums_, column_sums_;
  CrossingFits fits_;
  // Of each pixel of their windows, all first pixels first, depth and ray coordinate along the scanline.
  std::vector<float> z_, t_, row_t_;
  std::vector<float> wide_row_;  // the depths of an image row between margins of half a window without depth
};

/// The patches as line segments (neighbours along a scanline whose lines go on from one to the next) and
/// plane candidates, for whoever wants to see what the method sees.
void describePatches(const PatchGrid& grid, const ViewRays& rays, const Parameters& parameters,
                     std::vector<LineSegment>& segments, std::vector<PlaneCandidate>& candidates);

}  // namespace line_plane_segmentation
