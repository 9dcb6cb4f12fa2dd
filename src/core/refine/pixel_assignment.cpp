// SPDX-License-Identifier: BSD-3-Clause
#include "refine/pixel_assignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernels/row_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxSpeckle = 3;  // [px] in one row

}  // namespace

// A candidate stands for its own tile of the grid and for the eight around it.
void PixelAssigner::findSpans(const CandidateGrid& grid, const std::vector<int>& cluster_at, int row,
                              int width) {
  spans_.clear();
  const int* const here = cluster_at.data() + grid.indexOf(0, row);
  const std::array<const int*, 3> rows = {row > 0 ? here - grid.columns : here, here,
                                          row + 1 < grid.rows ? here + grid.columns : here};
  for (int c = 0; c < grid.columns; ++c) {
    // Only -1 has all bits set.
    if ((rows[0][c] & rows[1][c] & rows[2][c]) < 0) continue;
    const int first = std::max(0, c - 1) * grid.spacing;
    const int last = c + 2 >= grid.columns ? width : (c + 2) * grid.spacing;
    for (const int* clusters : rows) {
      const int cluster = clusters[c];
      if (cluster < 0) continue;
      int& open = open_span_[cluster];
      if (open >= 0 && spans_[open].last >= first) {
        spans_[open].last = last;
      } else {
        open = static_cast<int>(spans_.size());
        spans_.push_back({cluster, first, last});
      }
    }
  }
  for (const Span& span : spans_) open_span_[span.cluster] = -1;
}

void PixelAssigner::assignSpans(const std::vector<PlaneCluster>& clusters, const float* z,
                                const ViewRays& rays, double y) {
  for (const Span& span : spans_) {
    const std::size_t cluster = static_cast<std::size_t>(span.cluster);
    const InverseDepthPlane& plane = clusters[cluster].plane;
    const RowOfPlane row{static_cast<float>(plane.a), static_cast<float>(plane.b * y + plane.c),
                         inv_orthogonal_tolerance_[cluster], static_cast<std::uint16_t>(span.cluster + 1)};
    assignIfBetter(z + span.first, depth_over_noise_.data() + span.first, rays.x.data() + span.first,
                   span.last - span.first, row, best_.data() + span.first, label_.data() + span.first);
  }
}

// Intersects planes that are compared in the same columns, from the row with the ray y on.
void PixelAssigner::intersectPlanes(const std::vector<PlaneCluster>& clusters, const ViewRays& rays, double y,
                                    const DepthTolerance& tolerance) {
  intersections_.clear();
  if (rays.x.size() < 2 || creases_.empty()) return;
  const double x0 = static_cast<double>(rays.x.front());
  const double x_step = (static_cast<double>(rays.x.back()) - x0) / static_cast<double>(rays.x.size() - 1);
  const auto intersect = [&](const Span& a, const Span& b) {
    const int first = std::max(a.first, b.first), last = std::min(a.last, b.last);
    if (a.cluster == b.cluster || first >= last) return;
    const CreaseType crease = creases_.between(a.cluster, b.cluster);
    const InverseDepthPlane& plane = clusters[a.cluster].plane;
    const InverseDepthPlane& other = clusters[b.cluster].plane;
    // The difference of their inverse depths grows by this from column to column.
    const double slope = (plane.a - other.a) * x_step;
    if (crease == CreaseType::kNone || slope == 0.0) return;
    PlaneIntersection line{first,
                           last,
                           (other.at(x0, 0.0) - plane.at(x0, 0.0)) / slope,
                           (other.b - plane.b) / slope,
                           0.0,
                           static_cast<std::uint16_t>(a.cluster + 1),
                           static_cast<std::uint16_t>(b.cluster + 1)};
    const double column = std::clamp(line.offset + line.per_y * y, first + 0.0, last + 0.0);
    line.reach = tolerance.along(plane.at(x0 + x_step * column, y)) / std::fabs(slope);
    if ((slope < 0.0) != (crease == CreaseType::kConcave)) std::swap(line.left, line.right);
    intersections_.push_back(line);
  };
  // Spans are ordered by their first columns.
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (std::size_t k = i + 1; k < spans_.size() && spans_[k].first < spans_[i].last; ++k)
      intersect(spans_[i], spans_[k]);
  }
}

// Close to a line of intersection the noise decides which plane a pixel fits better. There it is assigned to
// the plane on its side of the line.
void PixelAssigner::splitAtCreases(double y) {
  for (const PlaneIntersection& line : intersections_) {
    const double at = line.offset + line.per_y * y;
    const double begin = std::max(at - line.reach, line.first + 0.0);
    const double end = std::min(at + line.reach, line.last - 1.0);
    if (!(begin <= end)) continue;
    const int last = static_cast<int>(end);
    for (int u = static_cast<int>(std::ceil(begin)); u <= last; ++u) {
      std::uint16_t& label = label_[u];
      const bool is_of_these = (label == line.left) | (label == line.right);
      const std::uint16_t side = u < at ? line.left : line.right;
      label = is_of_these ? side : label;
    }
  }
}

// Whether a few pixels of a row lie at the depth of those to their left and right, within the tolerance.
bool PixelAssigner::isLikeNeighbors(const float* z, const LabelRun& before, const LabelRun& speckle,
                                    const LabelRun& after) const {
  // The expected inverse depth is the mean of both, sum / product: the error times the product takes no
  // division.
  const float left = z[before.last - 1], right = z[after.first];
  const float product = 2.0F * left * right, sum = left + right;
  bool is_like = true;
  for (int u = speckle.first; u < speckle.last; ++u) {
    const float error = std::fabs(product - z[u] * sum) * depth_over_noise_[u];
    is_like &= !(error > product);
  }
  return is_like;
}

void PixelAssigner::assign(const DepthImage& depth, const ViewRays& rays, const CandidateGrid& grid,
                           const std::vector<PlaneCluster>& clusters, const std::vector<int>& cluster_at,
                           const Parameters& parameters, LabelRuns& image) {
  const std::size_t width = static_cast<std::size_t>(depth.width);
  depth_over_noise_.resize(width);
  best_.resize(width);
  label_.resize(width);
  open_span_.assign(clusters.size(), -1);
  const float factor = static_cast<float>(parameters.extraction.distance_noise_factor);
  const RowNoise noise{static_cast<float>(parameters.noise.floor) * factor,
                       static_cast<float>(parameters.noise.growth) * factor,
                       static_cast<float>(parameters.noise.nearest)};
  inv_orthogonal_tolerance_.clear();
  for (const PlaneCluster& cluster : clusters) {
    const double tolerance = parameters.extraction.plane_distance * cluster.plane.inverseDistance();
    inv_orthogonal_tolerance_.push_back(static_cast<float>(1.0 / tolerance));
  }

  creases_.find(rays, grid, clusters, cluster_at);
  const DepthTolerance crease_tolerance{parameters.noise, parameters.extraction.distance_noise_factor};

  image.clear();
  spans_.clear();
  intersections_.clear();
  for (int v = 0, row = -1; v < depth.height; ++v) {
    const int tile_row = std::min(v / grid.spacing, grid.rows - 1);
    const double y = static_cast<double>(rays.y[v]);
    if (tile_row != row) {
      findSpans(grid, cluster_at, tile_row, depth.width);
      intersectPlanes(clusters, rays, y, crease_tolerance);
    }
    row = tile_row;
    const float* z = depth.row(v);
    prepareRow(z, depth.width, noise, depth_over_noise_.data(), best_.data(), label_.data());
    assignSpans(clusters, z, rays, y);
    splitAtCreases(y);
    image.addRow(label_.data(), depth.width);
    image.joinOverSpeckles(kMaxSpeckle,
                           [this, z](const LabelRun& before, const LabelRun& speckle, const LabelRun& after) {
                             return isLikeNeighbors(z, before, speckle, after);
                           });
  }
}

}  // namespace line_plane_segmentation
