// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/crease.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxClusters = 200;  // of which every two are kept; more planes have no creases
constexpr int kMinVotes = 10;              // three or so patches beside three others

}  // namespace

Fold Creases::between(int cluster, int other) const {
  const int votes = vote_.empty() ? 0 : vote_[indexOf(cluster, other)];
  if (votes >= kMinVotes) return Fold::kInward;
  return votes <= -kMinVotes ? Fold::kOutward : Fold::kNone;
}

void Creases::vote(int cluster, int other, int sign) {
  vote_[indexOf(cluster, other)] += sign;
  vote_[indexOf(other, cluster)] += sign;
}

void Creases::find(const ViewRays& rays, const PatchGrid& grid, const std::vector<PatchCluster>& clusters,
                   const std::vector<int>& cluster_at) {
  count_ = clusters.size();
  vote_.clear();
  if (count_ < 2 || count_ > kMaxClusters) return;
  vote_.assign(count_ * count_, 0);
  const auto isNearer = [&](int cell, int cluster, int other) {
    const double x = rays.x[static_cast<std::size_t>(grid.pixelOf(cell % grid.columns))];
    const double y = rays.y[static_cast<std::size_t>(grid.pixelOf(cell / grid.columns))];
    return clusters[static_cast<std::size_t>(cluster)].plane.at(x, y) >
           clusters[static_cast<std::size_t>(other)].plane.at(x, y);
  };
  // Where a patch is seen, its plane is the nearer one of a fold inward, the farther one of a fold outward.
  const auto compare = [&](int cell, int neighbor) {
    const int cluster = cluster_at[static_cast<std::size_t>(cell)];
    const int other = cluster_at[static_cast<std::size_t>(neighbor)];
    if (cluster == other || cluster < 0 || other < 0) return;
    vote(cluster, other, isNearer(cell, cluster, other) ? 1 : -1);
    vote(cluster, other, isNearer(neighbor, other, cluster) ? 1 : -1);
  };
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      const int here = grid.indexOf(c, r);
      // Two crossings on, too: the patch between lies on the crease, and is in neither plane.
      for (int step = 1; step <= 2; ++step) {
        if (c + step < grid.columns) compare(here, here + step);
        if (r + step < grid.rows) compare(here, here + step * grid.columns);
      }
    }
  }
}

}  // namespace line_plane_segmentation
