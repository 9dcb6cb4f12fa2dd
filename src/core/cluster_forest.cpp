// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/cluster_forest.h"

#include <algorithm>
#include <limits>

namespace line_plane_segmentation {
namespace {

// [-] in limits; a pair of single patches may cost more than the clusters that they come to belong to, whose
// planes are surer, but not so much more.
constexpr double kHopeless = 4.0;

}  // namespace

void ClusterForest::clear() {
  clusters_.clear();
  parent_.clear();
  pairs_.clear();
}

void ClusterForest::add(const SurfacePatch& patch, double share) {
  clusters_.push_back(
      {patch.moments, patch.plane, patch.squared_error, patch.is_planar ? 1 : 0, share, false});
  parent_.push_back(static_cast<int>(parent_.size()));
}

// @param squared_error  that of both to their common plane; negative if they fix none
double ClusterForest::costOf(const PatchCluster& a, const PatchCluster& b, double squared_error) {
  if (squared_error < 0.0) return std::numeric_limits<double>::max();
  return (squared_error - a.squared_error - b.squared_error) / std::min(a.moments.pixels, b.moments.pixels);
}

double ClusterForest::costOf(int a, int b) const {
  const PatchCluster &first = cluster(a), &second = cluster(b);
  InverseDepthPlane plane;
  return costOf(first, second, (first.moments + second.moments).fit(plane));
}

void ClusterForest::addPair(int a, int b) {
  const int root_a = find(a), root_b = find(b);
  if (root_a == root_b || cluster(root_a).patches == 0 || cluster(root_b).patches == 0) return;
  Pair& pair = pairs_.emplace_back();
  pair.a = a;
  pair.b = b;
}

// Merges the clusters of a pair if that costs less than the limit.
// @return whether the pair is done with, its patches being in one cluster
bool ClusterForest::mergeIfCheaper(Pair& pair, double limit) {
  const int a = find(pair.a), b = find(pair.b);
  if (a == b) return true;
  const PatchCluster &first = cluster(a), &second = cluster(b);
  const int patches = first.patches + second.patches;
  if (patches == pair.patches && !(pair.cost < limit)) return false;
  const RegressionMoments moments = first.moments + second.moments;
  InverseDepthPlane plane;
  const double squared_error = moments.fit(plane);
  pair.cost = costOf(first, second, squared_error);
  pair.patches = patches;
  if (!(pair.cost < limit)) return false;
  replace(a, b, moments, plane, squared_error);
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
  const RegressionMoments moments = cluster(a).moments + cluster(b).moments;
  InverseDepthPlane plane;
  const double squared_error = moments.fit(plane);
  replace(a, b, moments, plane, squared_error);
}

// Puts what two clusters have in common in the place of the first.
void ClusterForest::replace(int a, int b, const RegressionMoments& moments, const InverseDepthPlane& plane,
                            double squared_error) {
  PatchCluster& merged = clusters_[static_cast<std::size_t>(a)];
  const PatchCluster& other = cluster(b);
  merged.moments = moments;
  merged.plane = plane;
  merged.squared_error = squared_error;
  merged.patches += other.patches;
  merged.share += other.share;
  parent_[static_cast<std::size_t>(b)] = a;
}

}  // namespace line_plane_segmentation
