// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "line_plane_segmentation/cluster_forest.h"
#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/surface_patch.h"

namespace line_plane_segmentation {

/// How two planes meet, as the camera sees it.
enum class Fold {
  kNone,     ///< they do not: there is a step, or they have too few patches beside each other
  kInward,   ///< like walls in the corner of a room: along each ray the nearer plane is seen
  kOutward,  ///< like the sides of a box: the farther one
};

/// Tells from the patches beside each other how planes meet. Which side of the line where two planes cross a
/// pixel lies on then tells better which one it is on than its own depth, whose noise is larger than what
/// parts the planes.
class Creases {
 public:
  /// Among more than 200 clusters none is found to meet another.
  /// @param cluster_at  of each crossing of the grid the cluster of its patch, or -1
  void find(const ViewRays& rays, const PatchGrid& grid, const std::vector<PatchCluster>& clusters,
            const std::vector<int>& cluster_at);

  /// Whether no two clusters can meet.
  bool empty() const { return vote_.empty(); }

  /// How the planes of two clusters meet.
  Fold between(int cluster, int other) const;

 private:
  std::size_t indexOf(int cluster, int other) const {
    return static_cast<std::size_t>(cluster) * count_ + static_cast<std::size_t>(other);
  }
  void vote(int cluster, int other, int sign);

  std::size_t count_ = 0;
  std::vector<int> vote_;  // of each two clusters: votes for inward less those for outward
};

}  // namespace line_plane_segmentation
