// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/cluster_forest.h"

namespace line_plane_segmentation {

/// Merges clusters that lie apart in one plane and have only nearer things between them: a table cut apart by
/// what stands on it, but not two surfaces with open space between.
class CoplanarMerger {
 public:
  /// @param forest  of the patches of `levels`, numbered alike
  void merge(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
             const Parameters& parameters, ClusterForest& forest);

 private:
  /// Two roots.
  struct Pair {
    double cost;
    int a, b;
  };

  void findRoots(int min_patches, ClusterForest& forest);
  void listPatches(ClusterForest& forest);
  int nearestPatch(const PatchLevels& levels, int root, int to) const;

  std::vector<int> roots_;
  std::vector<Pair> pairs_;
  // The patches of each of these clusters as a chain: its first at the root, each patch's next, and the last;
  // -1 ends it.
  std::vector<int> first_, next_, last_;
};

}  // namespace line_plane_segmentation
