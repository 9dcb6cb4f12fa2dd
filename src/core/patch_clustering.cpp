// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/patch_clustering.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxClusters = 65534;  // labels are 16 bit, and 65535 is kept free: "do not judge"
constexpr std::size_t kMaxCoplanarClusters =
    100;  // every pair of these is tried, so that the time stays bounded

// The sensor's own distortion bends a plane the more of the picture it fills: over so much of the grid, as
// much as max_curvedness allows a small one.
constexpr double kDistortedShare = 0.02;

// A patch whose pixels deviate from its cluster's plane by so many times what is usual there belongs to
// something else that runs into the plane; not so if that is within the tolerance anyway.
constexpr double kOutlierFactor = 4.0;
constexpr double kNeverOutlier = 0.5;  // in tolerances squared

}  // namespace

int PatchClusterer::find(int patch) {
  while (parent_[static_cast<std::size_t>(patch)] != patch) {
    int& parent = parent_[static_cast<std::size_t>(patch)];
    parent = parent_[static_cast<std::size_t>(parent)];
    patch = parent;
  }
  return patch;
}

double PatchClusterer::costOf(int a, int b, PatchCluster& merged) const {
  const PatchCluster& first = nodes_[static_cast<std::size_t>(a)];
  const PatchCluster& second = nodes_[static_cast<std::size_t>(b)];
  merged.moments = first.moments;
  merged.moments += second.moments;
  merged.squared_error = merged.moments.fit(merged.plane);
  if (merged.squared_error < 0.0) return std::numeric_limits<double>::max();
  merged.patches = first.patches + second.patches;
  return (merged.squared_error - first.squared_error - second.squared_error) /
         std::min(first.moments.pixels, second.moments.pixels);
}

// Merges the clusters of a pair if that costs less than the limit.
// @return whether the pair is done with, its patches being in one cluster
bool PatchClusterer::mergeIfCheaper(Pair& pair, double limit) {
  const int a = find(pair.a), b = find(pair.b);
  if (a == b) return true;
  const int patches =
      nodes_[static_cast<std::size_t>(a)].patches + nodes_[static_cast<std::size_t>(b)].patches;
  if (patches == pair.patches && !(pair.cost < limit)) return false;
  PatchCluster merged;
  pair.cost = costOf(a, b, merged);
  pair.patches = patches;
  if (!(pair.cost < limit)) return false;
  nodes_[static_cast<std::size_t>(a)] = merged;
  parent_[static_cast<std::size_t>(b)] = a;
  return true;
}

void PatchClusterer::addNeighbor(int a, int b, const PatchGrid& grid, double limit) {
  if (!grid.patches[static_cast<std::size_t>(a)].is_planar ||
      !grid.patches[static_cast<std::size_t>(b)].is_planar) {
    return;
  }
  PatchCluster merged;
  const double cost = costOf(a, b, merged);
  // A pair of single patches may cost more than the clusters that they come to belong to, whose planes are
  // surer.
  if (cost < 4.0 * limit) pairs_.push_back({cost, a, b, merged.patches});
}

void PatchClusterer::sortPairs() {
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& p, const Pair& q) {
    return std::tie(p.cost, p.a, p.b) < std::tie(q.cost, q.a, q.b);
  });
}

void PatchClusterer::mergeNeighbors(const PatchGrid& grid, double limit) {
  pairs_.clear();
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      const int i = grid.indexOf(c, r);
      if (c + 1 < grid.columns) addNeighbor(i, i + 1, grid, limit);
      if (r + 1 < grid.rows) addNeighbor(i, i + grid.columns, grid, limit);
    }
  }
  // The limit rises in steps, so that what is most alike has grown together before anything doubtful is
  // asked.
  for (const double share : {1.0 / 64, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 1.0}) {
    std::size_t kept = 0;
    for (Pair& pair : pairs_) {
      if (!mergeIfCheaper(pair, share * limit)) pairs_[kept++] = pair;
    }
    pairs_.resize(kept);
  }
}

// The patch of a cluster that is nearest in the grid to another patch.
int PatchClusterer::nearestPatch(const PatchGrid& grid, int root, int to) {
  int nearest = root, nearest_distance = std::numeric_limits<int>::max();
  for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
    if (find(i) != root) continue;
    const int dx = i % grid.columns - to % grid.columns, dy = i / grid.columns - to / grid.columns;
    if (dx * dx + dy * dy < nearest_distance) {
      nearest = i;
      nearest_distance = dx * dx + dy * dy;
    }
  }
  return nearest;
}

// Whether one looks at nothing behind the common plane on the straight way from one cluster to the other.
bool PatchClusterer::isOccludedBetween(int a, int b, const DepthImage& depth, const ViewRays& rays,
                                       const PatchGrid& grid, const Parameters& parameters) {
  PatchCluster merged;
  costOf(a, b, merged);
  const double inverse_distance = merged.plane.inverseDistance();
  const DepthTolerance tolerance{parameters.noise, 2.0 * parameters.extraction.distance_noise_factor,
                                 2.0 * parameters.extraction.plane_distance};
  const int from = nearestPatch(grid, a, b);
  const int to = nearestPatch(grid, b, from);
  const int u0 = grid.pixelOf(from % grid.columns), v0 = grid.pixelOf(from / grid.columns);
  const int du = grid.pixelOf(to % grid.columns) - u0, dv = grid.pixelOf(to / grid.columns) - v0;
  const int steps = std::max(std::abs(du), std::abs(dv));
  int behind = 0;
  for (int k = 0; k < steps; ++k) {
    const int u = u0 + du * k / steps, v = v0 + dv * k / steps;
    const float z = depth.at(u, v);
    if (!(z > 0.0F)) continue;
    const double w = 1.0 / static_cast<double>(z);
    const double expected =
        merged.plane.at(rays.x[static_cast<std::size_t>(u)], rays.y[static_cast<std::size_t>(v)]);
    if (expected - w > tolerance.at(w, inverse_distance)) ++behind;
  }
  return 4 * behind < steps;
}

void PatchClusterer::mergeCoplanar(const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
                                   const Parameters& parameters) {
  const double limit = parameters.clusters.coplanar_cost;
  if (!(limit > 0.0)) return;
  roots_.clear();
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
    if (find(i) == i && nodes_[static_cast<std::size_t>(i)].patches >= parameters.clusters.min_patches) {
      roots_.push_back(i);
    }
  }
  if (roots_.size() > kMaxCoplanarClusters) {
    std::nth_element(roots_.begin(), roots_.begin() + kMaxCoplanarClusters, roots_.end(),
                     [this](int a, int b) {
                       const int pa = nodes_[static_cast<std::size_t>(a)].patches,
                                 pb = nodes_[static_cast<std::size_t>(b)].patches;
                       return pa != pb ? pa > pb : a < b;
                     });
    roots_.resize(kMaxCoplanarClusters);
    std::sort(roots_.begin(), roots_.end());
  }
  pairs_.clear();
  PatchCluster merged;
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    for (std::size_t j = i + 1; j < roots_.size(); ++j) {
      const double cost = costOf(roots_[i], roots_[j], merged);
      if (cost < limit) pairs_.push_back({cost, roots_[i], roots_[j], merged.patches});
    }
  }
  sortPairs();
  for (Pair& pair : pairs_) {
    const int a = find(pair.a), b = find(pair.b);
    if (a == b || !(costOf(a, b, merged) < limit)) continue;
    if (isOccludedBetween(a, b, depth, rays, grid, parameters)) mergeIfCheaper(pair, limit);
  }
}

// Takes outliers out of the clusters, whose planes they would bend.
void PatchClusterer::trim(const PatchGrid& grid, std::vector<PatchCluster>& clusters,
                          std::vector<int>& cluster_of) {
  nodes_.assign(clusters.size(), PatchCluster{});
  for (std::size_t i = 0; i < cluster_of.size(); ++i) {
    if (cluster_of[i] < 0) continue;
    const std::size_t k = static_cast<std::size_t>(cluster_of[i]);
    const RegressionMoments& patch = grid.patches[i].moments;
    const double usual = clusters[k].squared_error / clusters[k].moments.pixels;
    if (patch.squaredErrorTo(clusters[k].plane) >
        std::max(kOutlierFactor * usual, kNeverOutlier) * patch.pixels) {
      cluster_of[i] = -1;
    } else {
      nodes_[k].moments += patch;
      ++nodes_[k].patches;
    }
  }
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    PatchCluster& trimmed = nodes_[k];
    trimmed.squared_error = trimmed.moments.fit(trimmed.plane);
    if (trimmed.squared_error >= 0.0) clusters[k] = trimmed;
  }
}

void PatchClusterer::cluster(const DepthImage& depth, const ViewRays& rays, const PatchGrid& grid,
                             const Parameters& parameters, std::vector<PatchCluster>& clusters,
                             std::vector<int>& cluster_of) {
  const std::size_t count = grid.patches.size();
  nodes_.resize(count);
  parent_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const SurfacePatch& patch = grid.patches[i];
    nodes_[i] = {patch.moments, patch.plane, patch.squared_error, patch.is_planar ? 1 : 0};
    parent_[i] = static_cast<int>(i);
  }
  mergeNeighbors(grid, parameters.clusters.merge_cost);
  mergeCoplanar(depth, rays, grid, parameters);

  clusters.clear();
  cluster_of.assign(count, -1);
  for (std::size_t i = 0; i < count && clusters.size() < kMaxClusters; ++i) {
    const PatchCluster& node = nodes_[i];
    if (find(static_cast<int>(i)) != static_cast<int>(i) || node.patches < parameters.clusters.min_patches)
      continue;
    const double share = node.patches / static_cast<double>(count);
    const double max_error = parameters.clusters.max_curvedness * (1.0 + share / kDistortedShare);
    if (node.squared_error > max_error * node.moments.pixels) continue;
    cluster_of[i] = static_cast<int>(clusters.size());
    clusters.push_back(nodes_[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    cluster_of[i] = cluster_of[static_cast<std::size_t>(find(static_cast<int>(i)))];
  }
  trim(grid, clusters, cluster_of);
}

}  // namespace line_plane_segmentation
