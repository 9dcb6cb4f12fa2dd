// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "line_plane_segmentation/surface_patch.h"

namespace line_plane_segmentation {
namespace {

// The line w = slope t + offset that a plane is along a scanline, t being the ray's coordinate along it.
struct InverseDepthLine {
  double slope, offset;
};

InverseDepthLine lineOf(const InverseDepthPlane& plane, ScanDirection direction, double across) {
  if (direction == ScanDirection::kRow) return {plane.a, plane.b * across + plane.c};
  return {plane.b, plane.a * across + plane.c};
}

// The line nearest to those of several patches, each of which counts by two points beside its middle.
class LineRegression {
 public:
  void add(const InverseDepthLine& line, double middle) {
    constexpr double kAside = 0.01;
    for (const double t : {middle - kAside, middle + kAside}) {
      const double w = line.slope * t + line.offset;
      n_ += 1.0;
      t_ += t;
      w_ += w;
      tt_ += t * t;
      tw_ += t * w;
    }
  }

  bool empty() const { return n_ == 0.0; }

  /// Not of none.
  InverseDepthLine line() const {
    const double slope = (n_ * tw_ - t_ * w_) / (n_ * tt_ - t_ * t_);
    return {slope, (w_ - slope * t_) / n_};
  }

 private:
  double n_ = 0.0, t_ = 0.0, w_ = 0.0, tt_ = 0.0, tw_ = 0.0;
};

// In the scan, Sy = t z and Sx = k z (Eq. 3), so that w = slope t + offset is the line slope Sy + (offset /
// k) Sx = 1.
void setPolarForm(const InverseDepthLine& line, double across, LineSegment& segment) {
  const double k = std::sqrt(across * across + 1.0);
  segment.alpha = std::atan2(line.slope, line.offset / k);
  segment.r = 1.0 / std::hypot(line.slope, line.offset / k);
}

// Walks one scanline of the grid and joins neighbours for as long as one line leads through all of them.
class SegmentJoiner {
 public:
  SegmentJoiner(const PatchGrid& grid, const std::vector<float>& along, const Parameters& parameters,
                std::vector<LineSegment>& segments)
      : grid_(grid),
        along_(along),
        half_window_(parameters.lines.line_window / 2),
        tolerance_{parameters.noise, parameters.patches.patch_noise_factor,
                   parameters.patches.patch_distance},
        segments_(segments) {}

  void walk(ScanDirection direction, int scanline, double across, int first_cell, int stride, int count) {
    LineRegression regression;
    for (int i = 0; i < count; ++i) {
      const int index = grid_.patchAt(first_cell + i * stride);
      if (index < 0) {
        regression = LineRegression{};
        continue;
      }
      const SurfacePatch& patch = grid_.patches[static_cast<std::size_t>(index)];
      const InverseDepthLine line = lineOf(patch.plane, direction, across);
      const int pixel = grid_.pixelOf(i);
      const double t = along_[static_cast<std::size_t>(pixel)];
      if (regression.empty() || !leadsTo(patch, line.slope * t + line.offset, regression.line(), t)) {
        LineSegment segment;
        segment.direction = direction;
        segment.scanline = scanline;
        segment.first = std::max(0, pixel - half_window_);
        segments_.push_back(segment);
        regression = LineRegression{};
      }
      LineSegment& segment = segments_.back();
      segment.last = std::min(static_cast<int>(along_.size()) - 1, pixel + half_window_);
      segment.points = segment.last - segment.first + 1;
      regression.add(line, t);
      setPolarForm(regression.line(), across, segment);
    }
  }

 private:
  // Whether the line goes through the middle of the patch, at t and w.
  bool leadsTo(const SurfacePatch& patch, double w, const InverseDepthLine& line, double t) const {
    return std::fabs(line.slope * t + line.offset - w) < tolerance_.at(w, patch.plane.inverseDistance());
  }

  const PatchGrid& grid_;
  const std::vector<float>& along_;
  int half_window_;
  DepthTolerance tolerance_;
  std::vector<LineSegment>& segments_;
};

}  // namespace

void describePatches(const PatchGrid& grid, const ViewRays& rays, const Parameters& parameters,
                     std::vector<LineSegment>& segments, std::vector<PlaneCandidate>& candidates) {
  segments.clear();
  candidates.clear();
  SegmentJoiner along_rows(grid, rays.x, parameters, segments);
  for (int r = 0; r < grid.rows; ++r) {
    const int v = grid.pixelOf(r);
    along_rows.walk(ScanDirection::kRow, v, rays.y[static_cast<std::size_t>(v)], grid.indexOf(0, r), 1,
                    grid.columns);
  }
  SegmentJoiner along_columns(grid, rays.y, parameters, segments);
  for (int c = 0; c < grid.columns; ++c) {
    const int u = grid.pixelOf(c);
    along_columns.walk(ScanDirection::kColumn, u, rays.x[static_cast<std::size_t>(u)], c, grid.columns,
                       grid.rows);
  }
  for (const SurfacePatch& patch : grid.patches) {
    PlaneCandidate candidate;
    candidate.u = patch.u;
    candidate.v = patch.v;
    candidate.d = 1.0 / patch.plane.inverseDistance();
    candidate.normal = -candidate.d * Eigen::Vector3d(patch.plane.a, patch.plane.b, patch.plane.c);
    candidates.push_back(candidate);
  }
}

}  // namespace line_plane_segmentation
