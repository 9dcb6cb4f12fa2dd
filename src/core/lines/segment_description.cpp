// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "lines/line_growing.h"

namespace line_plane_segmentation {
namespace {

// The polar form of a line rho = slope t + offset, and its covariance. In the scan (Eq. 1-3) Sy = t z and
// Sx = k z, so that it is the line slope Sy + (offset / k) Sx = 1.
void setPolarForm(const GrownSegment& grown, double orthogonal_ray, LineSegment& segment) {
  const InverseDepthLine line = fitInverseDepthLine(grown.sums);
  const double k = std::sqrt(orthogonal_ray * orthogonal_ray + 1.0);
  const double p = line.slope, q = line.offset / k, square = p * p + q * q;
  segment.alpha = std::atan2(p, q);
  segment.r = 1.0 / std::sqrt(square);

  // Covariance of (slope, offset) by the regression, from the residuals, then of (alpha, r) by its
  // derivatives.
  const LineSums& s = grown.sums;
  const double ctt = s.tt - s.t * s.t / s.n;
  const double variance = std::max(line.squared_error, grown.tolerance2) / std::max(1.0, s.n - 2.0);
  Eigen::Matrix2d covariance;
  covariance << 1.0, -s.t / s.n, -s.t / s.n, s.tt / s.n;
  covariance *= ctt > 0.0 ? variance / ctt : 0.0;
  Eigen::Matrix2d jacobian;
  const double r3 = segment.r / square;
  jacobian << q / square, -p / (square * k), -p * r3, -q * r3 / k;
  segment.covariance = jacobian * covariance * jacobian.transpose();
}

}  // namespace

void describeSegments(const DepthImage& depth, const ViewRays& rays, const ScanlineSet& set,
                      std::vector<LineSegment>& segments) {
  const bool is_row = set.direction == ScanDirection::kRow;
  const int length = is_row ? depth.width : depth.height;
  for (const GrownSegment& grown : set.segments) {
    LineSegment segment;
    segment.direction = set.direction;
    segment.scanline = set.pixels[grown.scanline];
    segment.first = length;
    for (int window = grown.first; window <= grown.last; ++window) {
      const int end = std::min(length, (window + 1) * set.window);
      for (int i = window * set.window; i < end; ++i) {
        const float z = is_row ? depth.at(i, segment.scanline) : depth.at(segment.scanline, i);
        // Windows with too few pixels for a line, in a hole that the segment spans, are not part of it.
        if (!(z > 0.0F) || set.sums[set.indexOf(grown.scanline, window)].n < kMinLinePixels) continue;
        segment.first = std::min(segment.first, i);
        segment.last = i;
        ++segment.points;
      }
    }
    const std::vector<float>& orthogonal_ray = is_row ? rays.y : rays.x;
    setPolarForm(grown, static_cast<double>(orthogonal_ray[segment.scanline]), segment);
    segments.push_back(segment);
  }
}

}  // namespace line_plane_segmentation
