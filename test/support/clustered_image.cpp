// SPDX-License-Identifier: BSD-3-Clause
#include "support/clustered_image.h"

#include "support/synthetic_depth.h"

namespace line_plane_segmentation {

PatchCluster clusterOf(const Surface& surface) {
  PatchCluster cluster;
  cluster.plane = {-surface.normal.x() / surface.d, -surface.normal.y() / surface.d,
                   -surface.normal.z() / surface.d};
  return cluster;
}

ClusteredImage::ClusteredImage(const DepthImage& depth, const Parameters& parameters)
    : rays(raysOf(kinectCamera(depth.width, depth.height), depth.width, depth.height)) {
  PatchDetector detector;
  PatchClusterer clusterer;
  detector.detect(depth, rays, parameters, levels.coarse);
  clusterer.clusterCoarse(levels.coarse, parameters, explained);
  detector.refine(depth, rays, parameters, explained, levels);
  clusterer.cluster(depth, rays, levels, parameters, clusters, cluster_of);
}

}  // namespace line_plane_segmentation
