// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/coplanar_merging.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <tuple>

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxClusters = 100;  // every pair of these is tried, so that the time stays bounded

// Whether one looks at nothing behind the common plane on the straight way from one patch to another.
bool isOccludedBetween(const SurfacePatch& from, const SurfacePatch& to, const InverseDepthPlane& plane,
                       const DepthImage& depth, const ViewRays& rays, const Parameters& parameters) {
  const double inverse_distance = plane.inverseDistance();
  const DepthTolerance tolerance{parameters.noise, 2.0 * parameters.extraction.distance_noise_factor,
                                 2.0 * parameters.extraction.plane_distance};
  const int u0 = from.u, v0 = from.v;
  const int du = to.u - u0, dv = to.v - v0;
  const int steps = std::max(std::abs(du), std::abs(dv));
  int behind = 0;
  for (int k = 0; k < steps; ++k) {
    const int u = u0 + du * k / steps, v = v0 + dv * k / steps;
    const float z = depth.at(u, v);
    if (!(z > 0.0F)) continue;
    const double w = 1.0 / static_cast<double>(z);
    const double expected =
        plane.at(rays.x[static_cast<std::size_t>(u)], rays.y[static_cast<std::size_t>(v)]);
    if (expected - w > tolerance.at(w, inverse_distance)) ++behind;
  }
  return 4 * behind < steps;
}

}  // namespace

// The roots of the largest clusters, in their order.
void CoplanarMerger::findRoots(int min_patches, ClusterForest& forest) {
  roots_.clear();
  for (int i = 0; i < forest.size(); ++i) {
    if (forest.find(i) == i && forest.patchesOf(i) >= min_patches) roots_.push_back(i);
  }
  if (roots_.size() <= kMaxClusters) return;
  std::nth_element(roots_.begin(), roots_.begin() + kMaxClusters, roots_.end(), [&forest](int a, int b) {
    const int patches_a = forest.patchesOf(a), patches_b = forest.patchesOf(b);
    return patches_a != patches_b ? patches_a > patches_b : a < b;
  });
  roots_.resize(kMaxClusters);
  std::sort(roots_.begin(), roots_.end());
}

void CoplanarMerger::listPatches(ClusterForest& forest) {
  const std::size_t count = static_cast<std::size_t>(forest.size());
  first_.assign(count, -1);
  next_.assign(count, -1);
  last_.resize(count);
  for (int i = forest.size() - 1; i >= 0; --i) {
    const std::size_t root = static_cast<std::size_t>(forest.find(i));
    if (first_[root] < 0) last_[root] = i;
    next_[static_cast<std::size_t>(i)] = first_[root];
    first_[root] = i;
  }
}

// The patch of a cluster that is nearest in the picture to another patch.
int CoplanarMerger::nearestPatch(const PatchLevels& levels, int root, int to) const {
  const int u = levels.patch(to).u, v = levels.patch(to).v;
  int nearest = root;
  std::int64_t nearest_distance = std::numeric_limits<std::int64_t>::max();
  for (int i = first_[static_cast<std::size_t>(root)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
    const std::int64_t du = levels.patch(i).u - u, dv = levels.patch(i).v - v;
    if (du * du + dv * dv < nearest_distance) {
      nearest = i;
      nearest_distance = du * du + dv * dv;
    }
  }
  return nearest;
}

void CoplanarMerger::merge(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
                           const Parameters& parameters, ClusterForest& forest) {
  const double limit = parameters.clusters.coplanar_cost;
  if (!(limit > 0.0)) return;
  findRoots(parameters.clusters.min_patches, forest);
  pairs_.clear();
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    for (std::size_t j = i + 1; j < roots_.size(); ++j) {
      const double cost = forest.costOf(roots_[i], roots_[j]);
      if (cost < limit) pairs_.push_back({cost, roots_[i], roots_[j]});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& p, const Pair& q) {
    return std::tie(p.cost, p.a, p.b) < std::tie(q.cost, q.a, q.b);
  });
  listPatches(forest);
  for (const Pair& pair : pairs_) {
    const int a = forest.find(pair.a), b = forest.find(pair.b);
    if (a == b || !(forest.costOf(a, b) < limit)) continue;
    InverseDepthPlane common;
    (forest.fitOf(a).moments + forest.fitOf(b).moments).fit(common);
    const int from = nearestPatch(levels, a, b), to = nearestPatch(levels, b, from);
    if (!isOccludedBetween(levels.patch(from), levels.patch(to), common, depth, rays, parameters)) continue;
    forest.merge(a, b);
    next_[static_cast<std::size_t>(last_[static_cast<std::size_t>(a)])] = first_[static_cast<std::size_t>(b)];
    last_[static_cast<std::size_t>(a)] = last_[static_cast<std::size_t>(b)];
  }
}

}  // namespace line_plane_segmentation
