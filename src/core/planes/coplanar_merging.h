// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planes/merge_tree.h"

namespace line_plane_segmentation {

/// Merges planes that lie apart in one plane and have only nearer surfaces between them: a table that the
/// objects on it occlude, but not two surfaces with open space between.
class CoplanarMerger {
 public:
  /// @param tree    of the candidates of `grid`; merged planes are appended to it
  /// @param planes  nodes of the tree; a merged plane replaces the two that it was made from
  void merge(const DepthImage& depth, const ViewRays& rays, const CandidateGrid& grid,
             const Parameters& parameters, MergeTree& tree, std::vector<int>& planes);

 private:
  struct Pixel {
    int u, v;
  };

  /// Two planes, by their indices in `planes`.
  struct Pair {
    double cost;
    int a, b;
  };

  void listPairs(const MergeTree& tree, const std::vector<int>& planes, double limit);
  void mergePairs(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                  MergeTree& tree);
  static Pixel nearest(const std::vector<Pixel>& pixels, Pixel to);
  static bool isOccludedBetween(Pixel from, Pixel to, const InverseDepthPlane& plane, const DepthImage& depth,
                                const ViewRays& rays, const Parameters& parameters);

  static bool isSameDepthBetween(Pixel from, Pixel to, const InverseDepthPlane& plane,
                                 const InverseDepthPlane& other, const ViewRays& rays,
                                 const DepthTolerance& tolerance);

  std::size_t indexOf(int a, int b) const {
    return static_cast<std::size_t>(a) * compared_.size() + static_cast<std::size_t>(b);
  }

  std::vector<Pair> pairs_;
  std::vector<int> compared_;               // the planes compared, as they become
  std::vector<std::vector<Pixel>> pixels_;  // pixels of the candidates per plane compared
  std::vector<int> merged_into_;            // index in `planes` per plane, itself at first
  std::vector<std::uint8_t> rejected_;      // 1 per pair whose merge was rejected, until the first grows
};

}  // namespace line_plane_segmentation
