// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "planes/plane_clustering.h"

namespace line_plane_segmentation {

/// Does what RegionCleaner does, pixel by pixel and with divisions: pieces by flood fill, each with a list of
/// the labels along its border. The labels of the result are not numbered anew: they stay k + 1 for cluster
/// k, and no plane is too small.
std::vector<std::uint16_t> referenceCleanup(const DepthImage& depth, const ViewRays& rays,
                                            const std::vector<PlaneCluster>& clusters,
                                            const Parameters& parameters,
                                            const std::vector<std::uint16_t>& labels);

}  // namespace line_plane_segmentation
