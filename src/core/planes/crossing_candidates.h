// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"
#include "lines/scanline_set.h"
#include "planes/inverse_depth_plane.h"

namespace line_plane_segmentation {

/// A plane candidate of the default method: the local plane where a row segment and a column segment cross,
/// fitted to the windows of both segments around the crossing.
struct CrossingCandidate : FittedPixels {
  double x = 0.0, y = 0.0, rho = 0.0;  ///< mean ray and mean inverse depth [1/m] of the pixels
  double inv_tolerance = 0.0;          ///< [m] 1 / tolerance of each pixel
  int u = 0, v = 0;                    ///< [px] the crossing
  int cell = 0;                        ///< index of the crossing in its CandidateGrid

  /// Mean deviation of the pixels from a plane [1/m], positive if they are nearer.
  double deviationFrom(const InverseDepthPlane& other) const { return rho - other.at(x, y); }

  /// The candidate as the paper describes it: normal, d, and curvature (see PlaneCandidate::curvature).
  PlaneCandidate describe() const;
};

/// The crossings of all scanlines, row by row, and the candidates at them.
struct CandidateGrid {
  int spacing = 1;                ///< [px] between scanlines
  int columns = 0, rows = 0;      ///< number of scanlines of each direction
  std::vector<int> candidate_at;  ///< index in `candidates` per crossing, -1 if none
  std::vector<CrossingCandidate> candidates;

  /// Two candidates that are neighbours on one line segment.
  struct Link {
    int a, b;
  };
  std::vector<Link> links;

  /// The candidate at a crossing that has one.
  const CrossingCandidate& candidateAt(int cell) const { return candidates[candidate_at[cell]]; }
  int crossings() const { return columns * rows; }
  double fractionPerCandidate() const { return 1.0 / std::max(1, crossings()); }
  int indexOf(int column, int row) const { return row * columns + column; }

  /// The crossing some columns to the right and rows below, -1 outside of the grid.
  int cellBeside(int cell, int to_right, int below) const {
    const int column = cell % columns + to_right, row = cell / columns + below;
    const bool is_inside = column >= 0 && column < columns && row >= 0 && row < rows;
    return is_inside ? indexOf(column, row) : -1;
  }
};

/// Stage "candidates" of the default method.
class CrossingDetector {
 public:
  /// Makes a candidate wherever a row segment and a column segment cross and are coplanar, and links those
  /// that follow each other on a segment.
  /// @param rows, columns  with grown segments
  void detect(const ViewRays& rays, const ScanlineSet& rows, const ScanlineSet& columns,
              const Parameters& parameters, CandidateGrid& grid);
};

}  // namespace line_plane_segmentation
