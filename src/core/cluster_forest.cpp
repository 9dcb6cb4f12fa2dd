// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/cluster_forest.h"

#include <algorithm>
#include <limits>

namespace line_plane_segmentation {
namespace {

// [-] in limits; a pair of single patches may cost more than the clusters that they come to belong to, whose
// planes are surer, but not so much more.
constexpr double kHopeless = 4.0;

constexpr double kInfiniteCost = std::numeric_limits<double>::max();

}  // namespace

void ClusterForest::clear() {
  parent_.clear();
  patches_.clear();
  share_.clear();
  single_.clear();
  merged_at_.clear();
  merged_.clear();
  pairs_.clear();
}

void ClusterForest::add(const SurfacePatch& patch, double share) {
  parent_.push_back(static_cast<int>(parent_.size()));
  patches_.push_back(1);
  share_.push_back(share);
  single_.push_back(&patch);
  merged_at_.push_back(-1);
}

PatchCluster ClusterForest::cluster(int root) const {
  return {fitOf(root), patchesOf(root), shareOf(root), false};
}

double ClusterForest::costOf(int a, int b) const {
  const FittedPixels &first = fitOf(a), &second = fitOf(b);
  InverseDepthPlane plane;
  const double squared_error = (first.moments + second.moments).fit(plane);
  if (squared_error < 0.0) return kInfiniteCost;
  return (squared_error - first.squared_error - second.squared_error) /
         std::min(first.moments.pixels, second.moments.pixels);
}

// Merges the clusters of a pair if that costs less than the limit.
// @return whether the pair is done with, its patches being in one cluster
bool ClusterForest::mergeIfCheaper(Pair& pair, double limit) {
  const int a = find(pair.a), b = find(pair.b);
  if (a == b) return true;
  const int patches = patchesOf(a) + patchesOf(b);
  if (patches == pair.patches && !(pair.cost < limit)) return false;
  const FittedPixels &first = fitOf(a), &second = fitOf(b);
  FittedPixels both;
  both.moments = first.moments + second.moments;
  const bool is_fixed = both.moments.fit(both.plane, both.squared_error);
  const double added_error = both.squared_error - first.squared_error - second.squared_error;
  const double pixels = std::min(first.moments.pixels, second.moments.pixels);
  pair.cost = is_fixed ? added_error / pixels : kInfiniteCost;
  pair.patches = patches;
  // As pair.cost < limit, but without waiting for its division: most of the clustering is done here.
  if (!(is_fixed & (added_error < limit * pixels))) return false;
  replace(a, b, both);
  return true;
}

void ClusterForest::mergePairs(double limit, std::initializer_list<double> rounds) {
  for (const double share : rounds) {
    std::size_t kept = 0;
    for (Pair& pair : pairs_) {
      if (!mergeIfCheaper(pair, share * limit) && pair.cost < kHopeless * limit) pairs_[kept++] = pair;
    }
    pairs_.resize(kept);
  }
  pairs_.clear();
}

void ClusterForest::merge(int a, int b) {
  FittedPixels both;
  both.moments = fitOf(a).moments + fitOf(b).moments;
  both.squared_error = both.moments.fit(both.plane);
  replace(a, b, both);
}

// Puts what two clusters have in common in the place of the first.
void ClusterForest::replace(int a, int b, const FittedPixels& both) {
  const std::size_t to = static_cast<std::size_t>(a), from = static_cast<std::size_t>(b);
  if (merged_at_[to] < 0) merged_at_[to] = merged_at_[from];
  if (merged_at_[to] < 0) {
    merged_at_[to] = static_cast<int>(merged_.size());
    merged_.push_back(both);
  } else {
    merged_[static_cast<std::size_t>(merged_at_[to])] = both;
  }
  patches_[to] += patches_[from];
  share_[to] += share_[from];
  parent_[from] = a;
}

}  // namespace line_plane_segmentation
