// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/cluster_forest.h"
#include "line_plane_segmentation/coplanar_merging.h"
#include "line_plane_segmentation/surface_bend.h"

namespace line_plane_segmentation {

/// Stage 4 of the adaptive method, first half: which planes there are. Clusters of patches grow by merging
/// neighbours, those that cost least first; what lies a small but steady step off a plane, as a door does, is
/// a plane of its own, and what is curved or rough is none.
class PatchClusterer {
 public:
  /// Lets the coarse patches of an image grow together.
  /// @param coarse     stays where it is until cluster() has returned
  /// @param explained  for each crossing whether it needs no closer look: it is part of a plane, or clutter
  void clusterCoarse(const PatchGrid& coarse, const Parameters& parameters,
                     std::vector<std::uint8_t>& explained);

  /// Goes on with the same image: adds its fine patches, and merges coplanar clusters.
  /// @param levels      its coarse grid is the one that clusterCoarse() got
  /// @param cluster_of  for each patch its index in `clusters`, or -1
  void cluster(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
               const Parameters& parameters, std::vector<PatchCluster>& clusters,
               std::vector<int>& cluster_of);

 private:
  /// How far the patches beside a plane lie off it, in tolerances.
  struct Step {
    int patches = 0;
    double sum = 0.0, squares = 0.0;

    void add(double deviation) {
      ++patches;
      sum += deviation;
      squares += deviation * deviation;
    }
    bool isSteady() const;
  };

  bool isPlaneAt(int root, const ClusterParameters& parameters) const;
  void dismissClutter(const PatchGrid& coarse, std::vector<std::uint8_t>& explained);
  void addFine(const PatchLevels& levels, double limit);
  void trim(const PatchLevels& levels, int min_patches, std::vector<PatchCluster>& clusters,
            std::vector<int>& cluster_of);
  void partAtSteps(const PatchLevels& levels, const ClusterParameters& parameters,
                   std::vector<PatchCluster>& clusters, std::vector<int>& cluster_of);
  void dropUneven(const PatchLevels& levels, const ClusterParameters& parameters,
                  std::vector<PatchCluster>& clusters, std::vector<int>& cluster_of);

  ClusterForest forest_;
  CoplanarMerger coplanar_merger_;
  std::vector<std::uint8_t> in_plane_;                 // of each coarse crossing
  std::vector<PatchCluster> coarse_sums_, fine_sums_;  // of each cluster
  std::vector<int> untrimmed_;                         // the cluster of each patch before trimming
  std::vector<int> outlier_of_;                        // of each patch, beside which cluster's plane it lies
  std::vector<PatchCluster> outliers_;                 // of each cluster
  std::vector<Step> steps_;                            // of each cluster
  std::vector<SurfaceBend> bends_;
  std::vector<int> new_index_;
};

}  // namespace line_plane_segmentation
