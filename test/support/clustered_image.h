// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/patch_clustering.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {

/// A cluster of which only its plane is told: a surface's.
PatchCluster clusterOf(const Surface& surface);

/// What the adaptive method's stages up to the clusters make of an image of the Kinect's camera.
struct ClusteredImage {
  ViewRays rays;
  PatchLevels levels;
  std::vector<std::uint8_t> explained;
  std::vector<PatchCluster> clusters;
  std::vector<int> cluster_of;

  /// @param parameters  resolved
  ClusteredImage(const DepthImage& depth, const Parameters& parameters);

  /// The cluster of the coarse patch nearest to a pixel, or -1.
  int at(int u, int v) const {
    const int patch = levels.coarse.patchAt(levels.coarse.indexAt(u, v));
    return patch < 0 ? -1 : cluster_of[static_cast<std::size_t>(patch)];
  }

  /// Of each coarse crossing the cluster of its patch, or -1.
  std::vector<int> coarseClusters() const {
    std::vector<int> cluster_at;
    levels.coarse.spread(cluster_of, 0, cluster_at);
    return cluster_at;
  }
};

}  // namespace line_plane_segmentation
