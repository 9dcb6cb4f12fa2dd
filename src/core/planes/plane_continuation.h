// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "planes/crossing_candidates.h"
#include "planes/depth_step.h"
#include "planes/plane_clustering.h"

namespace line_plane_segmentation {

/// Parts of a plane that come out as clusters of their own. Residual sensor distortion bends large planes,
/// most of all in the corners of the image, so that a part there is another plane, or no plane at all.
///
/// A cluster continues a larger plane if both lie beside each other, agree in depth there without a step, and
/// turn by no more than distortion and the uncertainty of the smaller one's slope explain.
class PlaneContinuation {
 public:
  /// @param cluster_at  index in `clusters` per crossing of the grid, -1 if none
  /// @param plane_of    receives, per cluster, the cluster of the plane that it belongs to: itself for a
  ///                    plane that continues no other, -1 for what is in no plane
  void find(const ViewRays& rays, const CandidateGrid& grid, const std::vector<PlaneCluster>& clusters,
            const std::vector<int>& cluster_at, const Parameters& parameters, std::vector<int>& plane_of);

 private:
  /// Candidates of two clusters beside each other, in one row or column of the grid.
  struct Contact {
    std::uint32_t clusters;  ///< the lower index in the upper half
    std::uint32_t order;     ///< in which the contacts were found
    int count;
    double squared_gap;  ///< [tolerance²] sum of the planes' differences in depth
    double rho;          ///< [1/m] sum of their inverse depths
    MeanStep step;       ///< from the cluster with the lower index to the other one
  };

  struct Tolerances {
    DepthTolerance gap;   ///< between the planes
    DepthTolerance step;  ///< between the surfaces
  };

  void addContact(const ViewRays& rays, const std::vector<PlaneCluster>& clusters, int a, int b,
                  const ClusterContact& contact, int distance, const Tolerances& tolerances);
  void listContacts(const ViewRays& rays, const CandidateGrid& grid,
                    const std::vector<PlaneCluster>& clusters, const std::vector<int>& cluster_at,
                    const Tolerances& tolerances);
  void sumContacts();
  static bool isContinued(const PlaneCluster& small, const PlaneCluster& large, const Contact& contact);

  std::vector<Contact> contacts_;
};

}  // namespace line_plane_segmentation
