// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/patch_clustering.h"

namespace line_plane_segmentation {

/// How two planes meet, as the camera sees it.
enum class Fold : int {
  kNone = 0,     ///< they have no, or too few, patches beside each other
  kInward = 1,   ///< like walls in the corner of a room: along each ray the nearer plane is seen
  kOutward = 2,  ///< like the sides of a box: the farther one
};

/// Tells from the patches beside each other how planes meet. Which side of the line where two planes cross a
/// pixel lies on then tells better which one it is on than its own depth, whose noise is larger than what
/// parts the planes.
class Creases {
 public:
  /// @param cluster_of  of each patch its cluster, or -1
  void find(const ViewRays& rays, const PatchLevels& levels, const std::vector<PatchCluster>& clusters,
            const std::vector<int>& cluster_of);

  /// How the planes of two clusters meet.
  Fold between(int cluster, int other) const;

 private:
  std::size_t indexOf(int cluster, int other) const {
    return static_cast<std::size_t>(cluster) * count_ + static_cast<std::size_t>(other);
  }
  void vote(int cluster, int other, int sign);

  std::size_t count_ = 0;
  std::vector<int> vote_;  // of each two clusters: more is inward
};

}  // namespace line_plane_segmentation
