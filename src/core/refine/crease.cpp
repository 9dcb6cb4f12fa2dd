// SPDX-License-Identifier: BSD-3-Clause
#include "refine/crease.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxClusters = 200;  // bounds the table of pairs
constexpr int kMinVotes = 10;              // about three candidates beside three others

}  // namespace

CreaseType Creases::between(int cluster, int other) const {
  const int votes = votes_.empty() ? 0 : votes_[indexOf(cluster, other)];
  if (votes >= kMinVotes) return CreaseType::kConcave;
  return votes <= -kMinVotes ? CreaseType::kConvex : CreaseType::kNone;
}

void Creases::vote(int cluster, int other, int sign) {
  votes_[indexOf(cluster, other)] += sign;
  votes_[indexOf(other, cluster)] += sign;
}

void Creases::find(const ViewRays& rays, const CandidateGrid& grid, const std::vector<PlaneCluster>& clusters,
                   const std::vector<int>& cluster_at) {
  count_ = clusters.size();
  votes_.clear();
  if (count_ < 2 || count_ > kMaxClusters) return;
  votes_.assign(count_ * count_, 0);
  const auto is_nearer = [&](int cell, int cluster, int other) {
    const CrossingCandidate& candidate = grid.candidateAt(cell);
    const double x = static_cast<double>(rays.x[candidate.u]);
    const double y = static_cast<double>(rays.y[candidate.v]);
    return clusters[cluster].plane.at(x, y) > clusters[other].plane.at(x, y);
  };
  // At a candidate its own plane is the nearer one at a concave edge, the farther one at a convex edge.
  const auto compare = [&](int cell, int neighbor) {
    const int cluster = cluster_at[cell];
    const int other = cluster_at[neighbor];
    if (cluster == other || cluster < 0 || other < 0) return;
    vote(cluster, other, is_nearer(cell, cluster, other) ? 1 : -1);
    vote(cluster, other, is_nearer(neighbor, other, cluster) ? 1 : -1);
  };
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      const int here = grid.indexOf(c, r);
      // Also two crossings apart: the candidate between lies on the edge and belongs to neither plane.
      for (int step = 1; step <= 2; ++step) {
        if (c + step < grid.columns) compare(here, here + step);
        if (r + step < grid.rows) compare(here, here + step * grid.columns);
      }
    }
  }
}

}  // namespace line_plane_segmentation
