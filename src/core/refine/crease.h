// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "planes/plane_clustering.h"

namespace line_plane_segmentation {

/// The edge at which two planes meet, as the camera sees it.
enum class CreaseType {
  kNone,     ///< none: there is a depth discontinuity, or too few candidates lie beside each other
  kConcave,  ///< like two walls in the corner of a room: along each ray the nearer plane is visible
  kConvex,   ///< like two faces of a box: the farther plane is visible
};

/// Classifies the edges between planes as concave or convex by comparing adjacent candidates. Close to the
/// line of intersection the depth noise exceeds the distance between the planes. There the side of the line
/// is a more reliable criterion than the depth of a pixel.
class Creases {
 public:
  /// With more than 200 clusters no edges are detected.
  /// @param cluster_at  index of a cluster per crossing of the grid, -1 if none
  void find(const ViewRays& rays, const CandidateGrid& grid, const std::vector<PlaneCluster>& clusters,
            const std::vector<int>& cluster_at);

  /// Whether no edges were detected.
  bool empty() const { return votes_.empty(); }

  /// The edge between the planes of two clusters.
  CreaseType between(int cluster, int other) const;

 private:
  std::size_t indexOf(int cluster, int other) const {
    return static_cast<std::size_t>(cluster) * count_ + static_cast<std::size_t>(other);
  }
  void vote(int cluster, int other, int sign);

  std::size_t count_ = 0;
  std::vector<int> votes_;  // per pair of clusters: votes for concave minus votes for convex
};

}  // namespace line_plane_segmentation
