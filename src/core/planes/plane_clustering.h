// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "planes/coplanar_merging.h"
#include "planes/merge_tree.h"

namespace line_plane_segmentation {

/// Candidates that grew together.
struct PlaneCluster : FittedPixels {
  int candidates = 0;
  RegressionMoments means;  ///< of the candidates' mean points, see MergeTree::means()
  bool is_plane = true;     ///< false for a curved or rough surface
  bool is_narrow = false;   ///< too few candidates to constrain the tilt: fit the plane to all of its pixels
};

/// Stage "extraction" of the default method, first half: which planes there are.
///
/// Candidates that follow each other on a line segment grow together (MergeTree). A cluster is a plane if it
/// is flat and not curved. Of a cluster that is not, its parts are planes if most of it belongs to such parts
/// and they explain it better than one quadric surface; otherwise it is a curved or rough surface. A plane
/// and a larger neighbour that one quadric surface explains as well are pieces of a curved surface, and the
/// smaller one is no plane; nor is the larger one if both are bent too much, nor a strip less than two
/// candidates wide beside a surface that is none. Coplanar planes are merged across what occludes them. Then
/// clusters of fewer than `min_patches` candidates are removed.
class PlaneClusterer {
 public:
  /// @param distortion  ratio of the depth errors over several candidates to those within one, at least 1
  /// @param clusters    receives the planes, then the surfaces that are none
  /// @param cluster_at  receives the index in `clusters` per crossing of the grid, -1 if none
  void cluster(const DepthImage& depth, const ViewRays& rays, const CandidateGrid& grid,
               const Parameters& parameters, double distortion, std::vector<PlaneCluster>& clusters,
               std::vector<int>& cluster_at);

 private:
  bool isPlane(int node, double fraction, const ClusterParameters& parameters);
  void addParts(int root, double fraction_per_candidate, int min_candidates,
                const ClusterParameters& parameters);
  void addPlanes(int root, double fraction_per_candidate, int min_candidates,
                 const ClusterParameters& parameters);
  void dropPiecesOfCurved(const CandidateGrid& grid, double fraction_per_candidate,
                          const ClusterParameters& parameters);

  void addCluster(int node, bool is_plane, const CandidateGrid& grid, std::vector<PlaneCluster>& clusters,
                  std::vector<int>& cluster_at);

  MergeTree tree_;
  CoplanarMerger coplanar_merger_;
  std::vector<int> planes_;  // nodes
  std::vector<int> others_;  // nodes that are no planes and have no parts that are
  std::vector<int> parts_;   // nodes still to be judged
  std::vector<int> owner_;   // node per candidate, -1 if it is in neither of them
  std::vector<std::pair<int, int>>
      neighbors_;            // two nodes, the smaller one first, for each link between them
  std::vector<int> strips_;  // nodes
};

}  // namespace line_plane_segmentation
