// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/inverse_depth_plane.h"
#include "line_plane_segmentation/line_segment.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_candidate.h"

namespace line_plane_segmentation {

/// The local plane where a row and a column cross, held up by two straight line primitives: the windows of
/// the two scanlines around the crossing.
struct SurfacePatch {
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
};

/// Stages 1 to 3 of the adaptive method. A window of a scanline is fitted by linear regression in inverse
/// depth, where the scan of a plane is a straight line too, in constant time from running sums.
class PatchDetector {
 public:
  /// @param parameters  resolved for the width of the image
  void detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters, PatchGrid& grid);

 private:
  /// Sums over the pixels of a scanline that have a depth: of their number, ray coordinate t and inverse
  /// depth w.
  struct LineSums {
    double n = 0.0, t = 0.0, tt = 0.0, w = 0.0, tw = 0.0, ww = 0.0;

    LineSums operator-(const LineSums& o) const {
      return {n - o.n, t - o.t, tt - o.tt, w - o.w, tw - o.tw, ww - o.ww};
    }
    double squaredErrorOfLine() const;
  };

  void sumRows(const DepthImage& depth, const ViewRays& rays, int half_window, const PatchGrid& grid);
  void sumColumns(const DepthImage& depth, const ViewRays& rays, int half_window, const PatchGrid& grid);
  static void fitCrossing(const LineSums& row, const LineSums& column, double x, double y,
                          const Parameters& parameters, SurfacePatch& patch);

  std::vector<LineSums> running_;         // along a scanline, or for all columns down to one row
  std::vector<LineSums> row_windows_;     // of every patch
  std::vector<LineSums> column_windows_;  // of every patch
};

/// The patches as line segments (neighbours along a scanline whose lines go on from one to the next) and
/// plane candidates, for whoever wants to see what the method sees.
void describePatches(const PatchGrid& grid, const ViewRays& rays, const Parameters& parameters,
                     std::vector<LineSegment>& segments, std::vector<PlaneCandidate>& candidates);

}  // namespace line_plane_segmentation
