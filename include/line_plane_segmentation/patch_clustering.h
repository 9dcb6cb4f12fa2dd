// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/surface_patch.h"

namespace line_plane_segmentation {

/// Patches that lie in one plane.
struct PatchCluster {
  RegressionMoments moments;
  InverseDepthPlane plane;
  double squared_error = 0.0;  ///< in units of the tolerance squared
  int patches = 0;
};

/// Stage 4 of the adaptive method, first half: which planes there are. Clusters of patches grow by merging,
/// those that cost least first. Merging two clusters costs the squared error that one common plane adds, for
/// each pixel of the smaller one: how far, in tolerances, the smaller cluster is moved off its own plane.
class PatchClusterer {
 public:
  /// Merges neighbours in the grid, then clusters apart that are coplanar and have only nearer things between
  /// them: a table cut apart by what stands on it, but not two surfaces with open space between.
  /// @param cluster_of  for each patch its index in `clusters`, or -1
  void cluster(const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
               const Parameters& parameters, std::vector<PatchCluster>& clusters,
               std::vector<int>& cluster_of);

 private:
  /// Two patches of clusters that may merge.
  struct Pair {
    double cost;  ///< of merging their clusters, as these were
    int a, b;
    int patches;  ///< of both clusters then: clusters only grow, so the cost holds while this does
  };

  int find(int patch);
  double costOf(int a, int b, PatchCluster& merged) const;
  bool mergeIfCheaper(Pair& pair, double limit);
  void addNeighbor(int a, int b, const PatchGrid& grid, double limit);
  void sortPairs();
  void mergeNeighbors(const PatchGrid& grid, double limit);
  void mergeCoplanar(const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
                     const Parameters& parameters);
  void trim(const PatchGrid& grid, std::vector<PatchCluster>& clusters, std::vector<int>& cluster_of);
  int nearestPatch(const PatchGrid& grid, int root, int to);
  bool isOccludedBetween(int a, int b, const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
                         const Parameters& parameters);

  std::vector<PatchCluster> nodes_;  // of each patch; at the root of a cluster, the whole cluster
  std::vector<int> parent_;
  std::vector<Pair> pairs_;
  std::vector<int> roots_;
};

}  // namespace line_plane_segmentation
