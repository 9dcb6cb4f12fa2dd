// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/segmentation.h"
#include "lines/line_sums.h"

namespace line_plane_segmentation {

/// A straight piece of a scanline in inverse depth: windows `first` to `last` of that scanline.
struct GrownSegment {
  int scanline = 0;            ///< index among the scanlines of its direction
  int first = 0, last = 0;     ///< windows, both included; windows without depth may lie between them
  LineSums sums;               ///< of its windows
  double squared_error = 0.0;  ///< [1/m²] of its pixels to its line
  double tolerance2 = 0.0;     ///< [1/m²] mean squared tolerance of its pixels
};

/// The scanlines of one direction, cut into windows of equal length, and the line segments grown on them.
struct ScanlineSet {
  ScanDirection direction = ScanDirection::kRow;
  int window = 1;                      ///< [px] length of a window; the last one of a scanline may be shorter
  int windows = 0;                     ///< per scanline
  std::vector<int> pixels;             ///< [px] the image row (or column) of each scanline
  std::vector<LineSums> sums;          ///< of each window, scanline by scanline
  std::vector<int> segment_of;         ///< index in `segments` per window, -1 if none
  std::vector<GrownSegment> segments;  ///< ordered by scanline, then by window

  int count() const { return static_cast<int>(pixels.size()); }
  int windowAt(int pixel) const { return pixel / window; }
  std::size_t indexOf(int scanline, int window_index) const {
    return static_cast<std::size_t>(scanline) * static_cast<std::size_t>(windows) +
           static_cast<std::size_t>(window_index);
  }
};

/// Lays scanlines of both directions over an image, sums their windows, and reuses its memory.
///
/// Scanlines lie `spacing` pixels apart. Where most pixels of a scanline are invalid but those of the row
/// (or column) beside it are not, as in registered depth images with their lattice of holes, the neighbour is
/// taken.
class WindowSummer {
 public:
  /// @param spacing  [px] between scanlines, at least 1
  /// @param window   [px] length of a window, at least 1
  void sum(const DepthImage& depth, const ViewRays& rays, int spacing, int window, ScanlineSet& rows,
           ScanlineSet& columns);

 private:
  void sumRows(const DepthImage& depth, const ViewRays& rays, ScanlineSet& rows);
  void sumColumns(const DepthImage& depth, const ViewRays& rays, ScanlineSet& columns);
  void addWindows(int pixels, int lanes);

  std::vector<float> z_, t_;       // of the windows summed at once: all first pixels first
  std::vector<double> sum_lanes_;  // of these windows: the six sums, one after the other
};

}  // namespace line_plane_segmentation
