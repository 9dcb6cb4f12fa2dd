// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"
#include "lines/scanline.h"

namespace line_plane_segmentation {

/// A line through points of a scan, Sx cos(alpha) + Sy sin(alpha) = r, and how well they fix it.
struct LineFit {
  double alpha = 0.0;  ///< [rad]
  double r = 0.0;      ///< [m], not negative
  /// Inverse of the covariance of (alpha, r): [aa ar; ar rr].
  double information_aa = 0.0;
  double information_ar = 0.0;
  double information_rr = 0.0;
};

/// Least-squares line (total, in polar form) through scan points, with the covariance that the noise
/// of Eq. 5 along the line of sight gives it (Arras & Siegwart 1997).
/// @param count  at least 2
LineFit fitLine(const ScanPoint* points, int count, const NoiseParameters& noise, double noise_factor);

/// Squared Mahalanobis distance in (alpha, r) from `line` to `other`, by the covariance of `line`.
double mahalanobis(const LineFit& line, const LineFit& other);

/// Stage 2, Algorithm 1: cuts scanlines into straight segments by line regression.
class LineExtractor {
 public:
  /// Scans rows, then columns.
  /// @param parameters  resolved for the width of the image
  /// @param segments    in the order of the scanlines, along each in the order of the pixels
  void extract(const DepthImage& depth, const CameraIntrinsics& camera, const Parameters& parameters,
               std::vector<LineSegment>& segments);

  /// The same for one scanline; appends to `segments`.
  void extract(const Scanline& scanline, const NoiseParameters& noise, const LineParameters& parameters,
               std::vector<LineSegment>& segments);

  /// Fidelity of the windows of a piece of a scan: the sum of the Mahalanobis distances of the three
  /// adjacent windows from the middle one. The first and the last window take their neighbour's.
  /// @return one number for each window, none if there are fewer than three windows
  const std::vector<double>& fidelity(const ScanPoint* points, int count, const NoiseParameters& noise,
                                      const LineParameters& parameters);

 private:
  struct Range {
    int first, last;  // points of the scanline, inclusive
    LineFit line;
  };

  void extractPiece(const Scanline& scanline, int first, int last, const NoiseParameters& noise,
                    const LineParameters& parameters);

  Scanline scanline_;
  std::vector<LineFit> windows_;
  std::vector<double> fidelity_;
  std::vector<Range> ranges_;
};

}  // namespace line_plane_segmentation
