// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "lines/scanline_set.h"
#include "lines/window_merging.h"
#include "planes/inverse_depth_plane.h"

namespace line_plane_segmentation {

/// Stage "lines" of the default method: grows line segments along rows and columns of the image.
///
/// The paper slides a window along a scanline, compares the lines of adjacent windows, and joins runs of
/// alike windows (Algorithm 1). Here the windows lie side by side, and segments grow by merging neighbours
/// along the scanline, those first whose merging adds the least squared error. Two neighbours are one line if
/// the added error is explained by noise or by the sensor's low-frequency distortion. A segment continues
/// after a hole of up to two windows. A single window that is not flat is no segment: it has depths of two
/// surfaces.
class LineGrower {
 public:
  /// Fills `segments` and `segment_of` of a set whose windows are summed.
  /// @param orthogonal_ray  ray coordinate of each row (ViewRays::y) or of each column (ViewRays::x)
  void grow(const std::vector<float>& orthogonal_ray, const Parameters& parameters, ScanlineSet& set);

 private:
  /// A segment while it grows.
  struct Node {
    int first, last;
    LineSums sums;
    double squared_error, tolerance2;
  };

  void mergeMostAlike(const std::vector<float>& orthogonal_ray, const ScanlineSet& set, int first,
                      const MergeRule& rule);
  void collect(int lane, int windows);
  static bool mergeIfAlike(Node& before, const Node& node);
  void mergeNeighbors();

  std::vector<GrowingSegments> grown_;  // one per window
  std::vector<StartBits> starts_;       // one per 64 windows
  std::vector<Node> nodes_;             // as many as a scanline has windows
  int count_ = 0;                       // of the nodes of one scanline
};

/// Estimates the depth errors of an image from windows of its scanlines: distances of a piece of a scanline
/// from the line through its two neighbours.
class NoiseMeter {
 public:
  /// Returns the ratio of the noise in the image to the noise model (Eq. 5), from the median over pieces of
  /// two windows in both sets. Returns 1 if there are fewer than 20 such pieces.
  double ratio(const ScanlineSet& rows, const ScanlineSet& columns, const NoiseParameters& noise);

  /// The same from longer pieces, of at least two windows. Over their length the noise of single pixels
  /// averages out, while sensor distortion, which bends planes, does not. The lower quartile is used, because
  /// surfaces that end or are curved increase the distances.
  /// @param length  [px] of a piece
  double distortionRatio(const ScanlineSet& rows, const ScanlineSet& columns, const NoiseParameters& noise,
                         double length);

 private:
  double ratioOver(const ScanlineSet& rows, const ScanlineSet& columns, const NoiseParameters& noise,
                   int windows, double quantile, double chi_squared);
  void collect(const ScanlineSet& set, const NoiseParameters& noise, int windows);

  std::vector<float> deviations_;  // [sigma_z²] squared
};

/// The segments as the paper describes them: polar form (Eq. 1-3), covariance, end points and points.
/// Appends to `segments`.
void describeSegments(const DepthImage& depth, const ViewRays& rays, const ScanlineSet& set,
                      std::vector<LineSegment>& segments);

}  // namespace line_plane_segmentation
