// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/inverse_depth_plane.h"
#include "line_plane_segmentation/window_sums.h"

/// The loops over windows of scanlines, many windows at a time, each simple enough for the compiler to
/// vectorise.
namespace line_plane_segmentation {

/// Sums over windows of `pixels` pixels each. Pixel k of window i has the depth z[k * windows + i], or none
/// if that is 0, and the ray coordinate t[k * windows + i].
void sumPixels(const float* z, const float* t, int pixels, int windows, const WindowLanes& sums);

/// What makes a crossing planar.
struct CrossingBounds {
  DepthTolerance tolerance;
  double flatness;    ///< largest mean squared error, in tolerances squared
  double min_points;  ///< of each window
};

/// Fits a plane to each two windows that cross, a row's and a column's.
/// @param x     ray coordinates of the crossings; all have the same y
/// @param fits  with a lane for each of them, at least
void fitCrossings(const WindowLanes& rows, const WindowLanes& columns, const float* x, double y, int count,
                  const CrossingBounds& bounds, CrossingFits& fits);

}  // namespace line_plane_segmentation
