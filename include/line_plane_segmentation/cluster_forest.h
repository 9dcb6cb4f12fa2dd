// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <vector>

#include "line_plane_segmentation/surface_patch.h"

namespace line_plane_segmentation {

/// Patches that lie in one plane.
struct PatchCluster : FittedPixels {
  int patches = 0;
  double share = 0.0;      ///< of the picture that its patches stand for
  bool is_narrow = false;  ///< its patches reach its borders, or over the step beside it: they tell where it
                           ///< is, but hardly how it is tilted
};

/// Clusters that grow by merging, each patch one at first: a forest, at whose roots is known what makes up a
/// cluster. Merging two costs the squared error that one common plane adds, for each pixel of the smaller
/// one: how far, in tolerances, the smaller cluster is moved off its own plane.
class ClusterForest {
 public:
  void clear();

  /// Adds a patch, the next in number, that stands for a share of the picture. It is not copied: it has to
  /// stay where it is for as long as the forest is asked.
  void add(const SurfacePatch& patch, double share);

  int size() const { return static_cast<int>(parent_.size()); }

  /// The root of a patch's cluster.
  int find(int patch) {
    while (parent_[static_cast<std::size_t>(patch)] != patch) {
      int& parent = parent_[static_cast<std::size_t>(patch)];
      parent = parent_[static_cast<std::size_t>(parent)];
      patch = parent;
    }
    return patch;
  }

  /// How many patches there are in the cluster of a root.
  int patchesOf(int root) const { return patches_[static_cast<std::size_t>(root)]; }

  /// The pixels of the cluster of a root, and their plane.
  const FittedPixels& fitOf(int root) const {
    const int merged = merged_at_[static_cast<std::size_t>(root)];
    return merged < 0 ? *single_[static_cast<std::size_t>(root)] : merged_[static_cast<std::size_t>(merged)];
  }

  /// The share of the picture that the cluster of a root stands for.
  double shareOf(int root) const { return share_[static_cast<std::size_t>(root)]; }

  /// All of the cluster of a root.
  PatchCluster cluster(int root) const;

  /// What it costs to merge the clusters of two roots; the largest number there is if they fix no plane.
  double costOf(int a, int b) const;

  /// Remembers two patches whose clusters may merge, for mergePairs().
  void addPair(int a, int b) { pairs_.push_back({0.0, a, b, 0}); }

  /// Merges the clusters of the pairs remembered that cost less than the limit, then forgets the pairs; those
  /// that come to cost several times the limit it forgets at once.
  /// @param rounds  shares of the limit, rising to 1, asked one after the other: so what is most alike has
  ///                grown together before anything doubtful is asked
  void mergePairs(double limit, std::initializer_list<double> rounds);

  /// Makes one of the clusters of two roots, whose cost is known not to be the largest number; `a` is its
  /// root.
  void merge(int a, int b);

 private:
  /// Two patches of clusters that may merge.
  struct Pair {
    double cost;  ///< of merging their clusters, as these were
    int a, b;
    int patches;  ///< of both clusters then: clusters only grow, so the cost holds while this does; 0 at
                  ///< first
  };

  void replace(int a, int b, const FittedPixels& both);
  bool mergeIfCheaper(Pair& pair, double limit);

  std::vector<int> parent_;
  // Of each patch; they hold at a root. What most questions ask is apart from the large rest, which is kept
  // once a cluster only.
  std::vector<int> patches_;
  std::vector<double> share_;
  std::vector<const FittedPixels*> single_;  // if it is the only one in its cluster
  std::vector<int> merged_at_;               // the index in merged_, or -1
  std::vector<FittedPixels> merged_;         // of clusters of more than one patch
  std::vector<Pair> pairs_;
};

}  // namespace line_plane_segmentation
