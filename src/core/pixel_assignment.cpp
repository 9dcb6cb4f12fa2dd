// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/pixel_assignment.h"

#include <algorithm>

#include "line_plane_segmentation/label_runs.h"
#include "row_kernels.h"

namespace line_plane_segmentation {

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

void PixelAssigner::assign(const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
                           const std::vector<PatchCluster>& clusters, const std::vector<int>& cluster_of,
                           const Parameters& parameters, std::vector<std::uint16_t>& labels) {
  const std::size_t width = static_cast<std::size_t>(depth.width);
  for (std::vector<float>* row : {&inverse_depth_, &along_, &best_}) row->resize(width);
  label_.resize(width);
  open_span_.assign(clusters.size(), -1);
  const NoiseParameters& noise = parameters.noise;
  const float noise_factor = static_cast<float>(parameters.extraction.distance_noise_factor);

  for (int v = 0; v < depth.height; ++v) {
    const int grid_row = std::min(v / grid.spacing, grid.rows - 1);
    if (grid.rows > 0 && (v == 0 || grid_row != std::min((v - 1) / grid.spacing, grid.rows - 1))) {
      findSpans(grid, grid_row, depth.width, cluster_of);
    }
    prepareRow(depth.row(v), depth.width,
               {static_cast<float>(noise.floor) * noise_factor, static_cast<float>(noise.growth) * noise_factor,
                static_cast<float>(noise.nearest)},
               inverse_depth_.data(), along_.data(), best_.data(), label_.data());
    for (const Span& span : spans_) {
      const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(span.cluster)].plane;
      const RowOfPlane row{
          static_cast<float>(plane.a), static_cast<float>(plane.b * rays.y[static_cast<std::size_t>(v)] + plane.c),
          static_cast<float>(parameters.extraction.plane_distance * plane.inverseDistance()), span.cluster + 1};
      assignIfBetter(inverse_depth_.data() + span.first, along_.data() + span.first, rays.x.data() + span.first,
                     span.last - span.first, row, best_.data() + span.first, label_.data() + span.first);
    }
    storeLabels(label_.data(), depth.width, labels.data() + depth.index(0, v));
  }
}

}  // namespace line_plane_segmentation
