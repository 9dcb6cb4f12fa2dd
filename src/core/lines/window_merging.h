// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "lines/line_sums.h"
#include "planes/inverse_depth_plane.h"

/// The first merges along scanlines, of several scanlines at a time: whether a window continues the segment
/// before it is as good as random, so that a processor that guesses a branch would often guess wrong.
namespace line_plane_segmentation {

constexpr int kMergedScanlines = 4;
using ScanlineLanes = std::array<double, kMergedScanlines>;

/// Fewest valid pixels of a window that is part of a segment.
constexpr double kMinLinePixels = 2.0;

/// A window is merged into the segment before it if the added squared error is below a bound.
struct MergeRule {
  double noise_error = 0.0;  ///< [tolerance²] noise's part of the bound; each pixel of the smaller one adds 1
  double fraction = 1.0;     ///< of the bound
  double max_hole = 1.0;     ///< [windows] from the last one of the segment
  DepthTolerance tolerance;
};

/// The last segment of each scanline, as it is behind a window.
struct GrowingSegments {
  ScanlineLanes n, t, tt, rho, t_rho, rho_rho;  ///< its sums
  ScanlineLanes squared_error, tolerance2;      ///< see GrownSegment
  ScanlineLanes last;                           ///< its last window
};

/// Where segments start: bit i of a word is window i of the 64 windows that the word stands for.
using StartBits = std::array<std::uint64_t, kMergedScanlines>;

/// Merges the windows of scanlines in their order.
/// @param sums      the first window of each scanline
/// @param inv_k2    of each scanline (Eq. 1-3)
/// @param windows   of a scanline
/// @param segments  receives one element per window
/// @param starts    receives one element per 64 windows, the last one of fewer
void mergeWindows(const std::array<const LineSums*, kMergedScanlines>& sums, const ScanlineLanes& inv_k2,
                  int windows, const MergeRule& rule, GrowingSegments* segments, StartBits* starts);

}  // namespace line_plane_segmentation
