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

/// Pixels and the plane that fits them best.
struct FittedPixels {
  RegressionMoments moments;
  InverseDepthPlane plane;
  double squared_error = 0.0;  ///< of the pixels to the plane, in units of the tolerance squared
};

/// The local plane where a row and a column cross, held up by two straight line primitives: the windows of
/// the two scanlines around the crossing, which lie in one plane.
struct SurfacePatch : FittedPixels {
  int u = 0, v = 0;  ///< [px] the crossing

  SurfacePatch() = default;
  SurfacePatch(const CrossingFits& fits, int lane, int pixel_u, int pixel_v)
      : FittedPixels{momentsOf(fits, lane),
                     {fits(kFitA, lane), fits(kFitB, lane), fits(kFitC, lane)},
                     fits(kFitSquaredError, lane)},
        u(pixel_u),
        v(pixel_v) {}
};

/// The crossings of all scanlines that are so far apart, row by row.
struct PatchGrid {
  int spacing = 1;  ///< [px] between scanlines
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> has_line;  ///< of each crossing whether one of its windows is straight, at least
  std::vector<int> patch_at;           ///< of each crossing its patch, or -1
  std::vector<SurfacePatch> patches;
  std::vector<int> cells;  ///< of each patch the number of its crossing

  int crossings() const { return columns * rows; }
  double shareOfPicture() const { return 1.0 / std::max(1, crossings()); }

  /// The image row through the crossings of a row of the grid; the same for columns.
  int pixelOf(int index) const { return spacing / 2 + index * spacing; }
  int indexOf(int column, int row) const { return row * columns + column; }

  /// The crossing nearest to a pixel: of the tile, `spacing` pixels wide, that it lies in.
  int indexAt(int u, int v) const {
    const int column = std::clamp(u / spacing, 0, columns - 1), row = std::clamp(v / spacing, 0, rows - 1);
    return indexOf(column, row);
  }

  /// The patch of a crossing, -1 also of those above the first row.
  int patchAt(int cell) const { return cell < 0 ? -1 : patch_at[static_cast<std::size_t>(cell)]; }

  /// Tells for each crossing what `of_patch` holds for its patch, there being others before the grid's first
  /// patch; -1 where there is none.
  void spread(const std::vector<int>& of_patch, int first, std::vector<int>& of_crossing) const;
};

/// All patches of an image: those of the scanlines, and of finer ones where there are lines that no plane
/// explains. They are numbered through, first the coarse ones, then the fine ones.
struct PatchLevels {
  PatchGrid coarse, fine;
  /// The column and the row of the coarse grid that the fine grid's columns and rows -1, 0, 1, ... lie in,
  /// one more at either side than there are.
  std::vector<int> tile_columns, tile_rows;

  int firstFine() const { return static_cast<int>(coarse.patches.size()); }
  int count() const { return firstFine() + static_cast<int>(fine.patches.size()); }
  const SurfacePatch& patch(int i) const {
    return i < firstFine() ? coarse.patches[static_cast<std::size_t>(i)]
                           : fine.patches[static_cast<std::size_t>(i - firstFine())];
  }
  int tileColumn(int fine_column) const { return tile_columns[static_cast<std::size_t>(fine_column + 1)]; }
  int tileRow(int fine_row) const { return tile_rows[static_cast<std::size_t>(fine_row + 1)]; }
};

/// Stages 1 to 3 of the adaptive method. A window of a scanline is fitted by linear regression in inverse
/// depth, where the scan of a plane is a straight line too.
class PatchDetector {
 public:
  /// @param parameters  resolved for the width of the image
  void detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters, PatchGrid& grid);

  /// Looks more closely, with shorter windows, where there are lines that no plane explains.
  /// @param explained  for each crossing of levels.coarse whether it needs no closer look
  /// @param levels     all but levels.coarse is filled; there are no fine patches if the parameters want
  ///                   nothing finer
  void refine(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
              const std::vector<std::uint8_t>& explained, PatchLevels& levels);

 private:
  void chooseColumns(const PatchGrid& grid, int half_window);
  void gatherWindows(const float* wide_row, int half_window, float* to) const;
  void sumWindows(const DepthImage& depth, const ViewRays& rays, int v, int half_window);
  void fit(double y, int half_window, const Parameters& parameters);
  void addRow(const DepthImage& depth, const ViewRays& rays, int row, int half_window,
              const Parameters& parameters, PatchGrid& grid);

  // Of a row of crossings, one lane a crossing: their columns in the grid and in the image, the rays there,
  // the sums of their windows, and what is fitted to these.
  std::vector<int> grid_columns_, columns_;
  std::vector<float> x_;
  WindowSums row_sums_, column_sums_;
  CrossingFits fits_;
  // Of each pixel of their windows, all first pixels first, depth and ray coordinate along the scanline.
  std::vector<float> z_, t_, row_t_;
  std::vector<float> wide_row_, wide_x_;  // an image row and its rays between margins of half a window
};

/// The patches as line segments (neighbours along a scanline whose lines go on from one to the next) and
/// plane candidates, for whoever wants to see what the method sees.
void describePatches(const PatchGrid& grid, const ViewRays& rays, const Parameters& parameters,
                     std::vector<LineSegment>& segments, std::vector<PlaneCandidate>& candidates);

}  // namespace line_plane_segmentation
