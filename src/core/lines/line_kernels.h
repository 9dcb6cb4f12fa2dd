// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Loops over windows of scanlines, many windows at a time.
namespace line_plane_segmentation {

/// LineSums of many windows as a structure of arrays: element i belongs to window i.
struct LineSumLanes {
  double *n, *t, *tt, *rho, *t_rho, *rho_rho;
};

/// Sums windows of `pixels` pixels each. The inverse depth of a pixel has single precision.
/// @param z     [m] depth: pixel k of window i is z[k * windows + i], 0 if invalid
/// @param t     ray coordinate along the scanline, in the same order
/// @param sums  receives one element per window
void sumWindows(const float* z, const float* t, int pixels, int windows, const LineSumLanes& sums);

}  // namespace line_plane_segmentation
