// SPDX-License-Identifier: BSD-3-Clause
#include "planes/candidate_detection.h"

#include <algorithm>

#include "planes/plane_fit.h"

namespace line_plane_segmentation {
namespace {

// The valid pixel of the segment nearest to `position` along it, towards its first point: a segment starts
// with one.
int validPixelAtOrBefore(const DepthImage& depth, const LineSegment& segment, int position) {
  const bool is_row = segment.direction == ScanDirection::kRow;
  int pixel = position;
  while (pixel > segment.first &&
         (is_row ? depth.at(pixel, segment.scanline) : depth.at(segment.scanline, pixel)) == 0.0F) {
    --pixel;
  }
  return pixel;
}

PointMoments momentsIn(const PixelWindow& window, const DepthImage& depth, const ViewRays& rays) {
  PointMoments moments;
  for (int v = window.first_v; v < window.last_v; ++v) {
    const float* z = depth.row(v);
    for (int u = window.first_u; u < window.last_u; ++u) {
      if (z[u] == 0.0F) continue;
      const double depth_here = z[u];
      moments.add({depth_here * rays.x[u], depth_here * rays.y[v], depth_here});
    }
  }
  return moments;
}

}  // namespace

PixelWindow windowAround(int u, int v, int side, int width, int height) {
  const int half = side / 2;
  return {std::max(0, u - half), std::min(width, u - half + side), std::max(0, v - half),
          std::min(height, v - half + side)};
}

void detectCandidates(const DepthImage& depth, const ViewRays& rays, const std::vector<LineSegment>& segments,
                      const CandidateParameters& parameters, std::vector<PlaneCandidate>& candidates) {
  candidates.clear();
  const int points = parameters.points_per_segment;
  for (const LineSegment& segment : segments) {
    for (int k = 0; k < points; ++k) {
      // One point lies in the middle; three or five in the middles of as many equal parts.
      const int position = segment.first + (segment.last - segment.first) * (2 * k + 1) / (2 * points);
      const int pixel = validPixelAtOrBefore(depth, segment, position);
      PlaneCandidate candidate;
      candidate.u = segment.direction == ScanDirection::kRow ? pixel : segment.scanline;
      candidate.v = segment.direction == ScanDirection::kRow ? segment.scanline : pixel;
      const PixelWindow window =
          windowAround(candidate.u, candidate.v, parameters.normal_window, depth.width, depth.height);
      const PointMoments moments = momentsIn(window, depth, rays);
      PlaneFit plane;
      if (moments.count < parameters.min_window_points || !fitPlane(moments, plane)) continue;
      if (plane.curvature >= parameters.max_curvature) continue;
      candidate.normal = plane.normal;
      candidate.d = plane.d;
      candidate.curvature = plane.curvature;
      candidates.push_back(candidate);
    }
  }
}

}  // namespace line_plane_segmentation
