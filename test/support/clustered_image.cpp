// SPDX-License-Identifier: BSD-3-Clause
#include "support/clustered_image.h"

#include <algorithm>

namespace line_plane_segmentation {

PlaneCluster clusterOf(const Surface& surface) {
  PlaneCluster cluster;
  cluster.plane = {-surface.normal.x() / surface.d, -surface.normal.y() / surface.d,
                   -surface.normal.z() / surface.d};
  return cluster;
}

CandidateImage::CandidateImage(const DepthImage& depth, const Parameters& parameters)
    : rays(raysOf(kinectCamera(depth.width, depth.height), depth.width, depth.height)) {
  WindowSummer().sum(depth, rays, parameters.scanlines.scanline_spacing, parameters.lines.line_window, rows,
                     columns);
  LineGrower grower;
  grower.grow(rays.y, parameters, rows);
  grower.grow(rays.x, parameters, columns);
  CrossingDetector().detect(rays, rows, columns, parameters, grid);
}

int CandidateImage::candidateAt(int u, int v) const {
  if (grid.crossings() == 0) return -1;
  const int column = std::min(u / grid.spacing, grid.columns - 1),
            row = std::min(v / grid.spacing, grid.rows - 1);
  return grid.candidate_at[static_cast<std::size_t>(grid.indexOf(column, row))];
}

ClusteredImage::ClusteredImage(const DepthImage& depth, const Parameters& parameters)
    : CandidateImage(depth, parameters) {
  PlaneClusterer().cluster(depth, rays, grid, parameters, 1.0, clusters, cluster_at);
  // Those that are no planes come last.
  while (!clusters.empty() && !clusters.back().is_plane) clusters.pop_back();
  for (int& cluster : cluster_at) cluster = cluster < static_cast<int>(clusters.size()) ? cluster : -1;
}

}  // namespace line_plane_segmentation
