// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/pixel_assignment.h"

#include <algorithm>
#include <cmath>

#include "row_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxSpeckle = 3;            // [px]
constexpr float kMaxSpeckleError = 2.0F;  // [-] in tolerances

}  // namespace

// A patch speaks for its own tile of the grid and for the eight around it.
void PixelAssigner::findSpans(const PatchGrid& grid, int row, int width, const std::vector<int>& cluster_of) {
  spans_.clear();
  const int first_row = std::max(0, row - 1), last_row = std::min(grid.rows - 1, row + 1);
  for (int c = 0; c < grid.columns; ++c) {
    const int first = std::max(0, c - 1) * grid.spacing;
    const int last = c + 2 >= grid.columns ? width : (c + 2) * grid.spacing;
    for (int r = first_row; r <= last_row; ++r) {
      const int cluster = cluster_of[static_cast<std::size_t>(grid.indexOf(c, r))];
      if (cluster < 0) continue;
      int& open = open_span_[static_cast<std::size_t>(cluster)];
      if (open >= 0 && spans_[static_cast<std::size_t>(open)].last >= first) {
        spans_[static_cast<std::size_t>(open)].last = last;
      } else {
        open = static_cast<int>(spans_.size());
        spans_.push_back({cluster, first, last});
      }
    }
  }
  for (const Span& span : spans_) open_span_[static_cast<std::size_t>(span.cluster)] = -1;
}

// Whether a few pixels lie at the depth of those to their left and right.
bool PixelAssigner::isLikeNeighbors(const LabelRun& before, const LabelRun& speckle,
                                    const LabelRun& after) const {
  const float expected = 0.5F * (inverse_depth_[static_cast<std::size_t>(before.last - 1)] +
                                 inverse_depth_[static_cast<std::size_t>(after.first)]);
  for (std::size_t u = static_cast<std::size_t>(speckle.first); u < static_cast<std::size_t>(speckle.last);
       ++u) {
    if (std::fabs(inverse_depth_[u] - expected) * inverse_tolerance_[u] > kMaxSpeckleError) return false;
  }
  return true;
}

void PixelAssigner::assign(const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
                           const std::vector<PatchCluster>& clusters, const std::vector<int>& cluster_of,
                           const Parameters& parameters, LabelRuns& image) {
  const std::size_t width = static_cast<std::size_t>(depth.width);
  for (std::vector<float>* row : {&inverse_depth_, &inverse_tolerance_, &best_}) row->resize(width);
  label_.resize(width);
  open_span_.assign(clusters.size(), -1);
  const float factor = static_cast<float>(parameters.extraction.distance_noise_factor);
  const RowNoise noise{static_cast<float>(parameters.noise.floor) * factor,
                       static_cast<float>(parameters.noise.growth) * factor,
                       static_cast<float>(parameters.noise.nearest)};

  image.clear();
  spans_.clear();
  for (int v = 0, spans_of = -1; v < depth.height; ++v) {
    const int grid_row = std::min(v / grid.spacing, grid.rows - 1);
    if (grid_row != spans_of) {
      findSpans(grid, grid_row, depth.width, cluster_of);
      spans_of = grid_row;
    }
    const float* z = depth.row(v);
    const double y = rays.y[static_cast<std::size_t>(v)];
    prepareRow(z, depth.width, noise, inverse_depth_.data(), inverse_tolerance_.data(), best_.data(),
               label_.data());
    for (const Span& span : spans_) {
      const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(span.cluster)].plane;
      const RowOfPlane row{
          static_cast<float>(plane.a), static_cast<float>(plane.b * y + plane.c),
          static_cast<float>(1.0 / (parameters.extraction.plane_distance * plane.inverseDistance())),
          static_cast<std::uint16_t>(span.cluster + 1)};
      assignIfBetter(z + span.first, inverse_depth_.data() + span.first,
                     inverse_tolerance_.data() + span.first, rays.x.data() + span.first,
                     span.last - span.first, row, best_.data() + span.first, label_.data() + span.first);
    }
    image.addRow(label_.data(), depth.width);
    image.joinOverSpeckles(kMaxSpeckle,
                           [this](const LabelRun& before, const LabelRun& speckle, const LabelRun& after) {
                             return isLikeNeighbors(before, speckle, after);
                           });
  }
}

}  // namespace line_plane_segmentation
