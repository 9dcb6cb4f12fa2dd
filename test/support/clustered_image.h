// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lines/line_growing.h"
#include "planes/plane_clustering.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {

/// A cluster of which only the plane is set: a surface's.
PlaneCluster clusterOf(const Surface& surface);

/// An image and the results of the default method's stages up to the candidates, for a Kinect's camera.
struct CandidateImage {
  ViewRays rays;
  ScanlineSet rows, columns;
  CandidateGrid grid;

  /// @param parameters  resolved
  CandidateImage(const DepthImage& depth, const Parameters& parameters);

  /// The candidate of the tile that a pixel lies in, -1 if none.
  int candidateAt(int u, int v) const;
};

/// The same up to the clusters that are planes.
struct ClusteredImage : CandidateImage {
  std::vector<PlaneCluster> clusters;
  std::vector<int> cluster_at;  ///< index in `clusters` per crossing, -1 if none

  ClusteredImage(const DepthImage& depth, const Parameters& parameters);

  /// The cluster of a candidate, -1 if none.
  int clusterOf(std::size_t candidate) const {
    return cluster_at[static_cast<std::size_t>(grid.candidates[candidate].cell)];
  }

  /// The cluster of the candidate of the tile that a pixel lies in, -1 if none.
  int at(int u, int v) const {
    const int candidate = candidateAt(u, v);
    return candidate < 0 ? -1 : clusterOf(static_cast<std::size_t>(candidate));
  }
};

}  // namespace line_plane_segmentation
