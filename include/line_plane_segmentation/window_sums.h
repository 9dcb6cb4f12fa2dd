// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "line_plane_segmentation/inverse_depth_plane.h"

namespace line_plane_segmentation {

/// A table of numbers that is worked on many columns at a time: a row for each of a few quantities, a column
/// for each of many things, called lanes. Its memory only grows.
template <int kRows>
class LaneTable {
 public:
  /// What the numbers are is then undefined.
  void resize(int lanes) {
    lanes_ = static_cast<std::size_t>(lanes);
    if (numbers_.size() < kRows * lanes_) numbers_.resize(kRows * lanes_);
  }

  double* row(int row) { return numbers_.data() + static_cast<std::size_t>(row) * lanes_; }

  double operator()(int row, int lane) const {
    return numbers_[static_cast<std::size_t>(row) * lanes_ + static_cast<std::size_t>(lane)];
  }

 private:
  std::size_t lanes_ = 0;
  std::vector<double> numbers_;
};

/// Sums over the pixels of a window of a scanline that have a depth, from which lines and planes are fitted.
/// One lane a window, a row for each Sum.
using WindowSums = LaneTable<6>;

/// Of the pixels' number n, ray coordinate t and inverse depth w = 1/z.
enum Sum : int { kSumN, kSumT, kSumTt, kSumW, kSumTw, kSumWw };

/// The sums of one window.
struct LineSums {
  double n, t, tt, w, tw, ww;

  /// The squared error of the line through the pixels, of no use if they have one t only.
  double squaredErrorOfLine() const {
    const double share = 1.0 / n;
    const double ctt = tt - t * t * share, ctw = tw - t * w * share, cww = ww - w * w * share;
    return cww - ctw * ctw / ctt;
  }
};

/// The moments of the pixels of two windows that cross where the rays are x and y, of a row and of a column.
inline RegressionMoments momentsOfCrossing(const LineSums& row, const LineSums& column, double x, double y) {
  const double n = row.n + column.n;
  return {row.tt + x * x * column.n,
          y * row.t + x * column.t,
          y * y * row.n + column.tt,
          row.t + x * column.n,
          y * row.n + column.t,
          n,
          row.tw + x * column.w,
          y * row.w + column.tw,
          row.w + column.w,
          row.ww + column.ww,
          n};
}

/// The sums of neighbouring windows.
struct WindowLanes {
  double *n, *t, *tt, *w, *tw, *ww;

  LineSums operator[](int i) const { return {n[i], t[i], tt[i], w[i], tw[i], ww[i]}; }
};

inline WindowLanes lanesOf(WindowSums& sums) {
  return {sums.row(kSumN), sums.row(kSumT),  sums.row(kSumTt),
          sums.row(kSumW), sums.row(kSumTw), sums.row(kSumWw)};
}

/// What is fitted to windows that cross, a row's and a column's. One lane a crossing, a row for each Fit.
using CrossingFits = LaneTable<17>;

enum Fit : int {
  kFitXx,  ///< the RegressionMoments of the pixels of both windows, in their order
  kFitXy,
  kFitYy,
  kFitX,
  kFitY,
  kFitOne,
  kFitXw,
  kFitYw,
  kFitW,
  kFitWw,
  kFitPixels,
  kFitA,  ///< the InverseDepthPlane
  kFitB,
  kFitC,
  kFitSquaredError,  ///< of the pixels to the plane, in tolerances squared
  kFitLines,         ///< how many of the two windows are straight: 0, 1, 2; 0 if the pixels fix no plane
  kFitPlanar,        ///< 1: both are, and lie in the plane; else 0
};

/// The moments of a crossing.
inline RegressionMoments momentsOf(const CrossingFits& fits, int lane) {
  return {fits(kFitXx, lane), fits(kFitXy, lane),  fits(kFitYy, lane),    fits(kFitX, lane),
          fits(kFitY, lane),  fits(kFitOne, lane), fits(kFitXw, lane),    fits(kFitYw, lane),
          fits(kFitW, lane),  fits(kFitWw, lane),  fits(kFitPixels, lane)};
}

}  // namespace line_plane_segmentation
