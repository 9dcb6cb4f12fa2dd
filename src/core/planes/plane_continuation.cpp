// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_continuation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace line_plane_segmentation {
namespace {

// Largest number of crossings from one cluster to the other: between them, distortion leaves crossings in
// neither.
constexpr int kMaxGap = 4;

// [tolerance²] mean square by which the planes may differ where the clusters meet: two tolerances.
constexpr double kMaxSquaredGap = 4.0;

// [-] change of relative depth per unit of the tangent of the view angle: 0.2 is the turn of a surface seen
// from the front by 11 degrees, and 2 % of depth over 57 of 640 pixels, what Kinects show near the corners.
constexpr double kMaxTurn = 0.2;

// A slope is uncertain by so many standard deviations (95 %).
constexpr double kSlopeDeviations = 2.0;

// Standard deviation of a fitted plane's slope [1/m per unit of the tangent of the view angle].
double slopeDeviation(const FittedPixels& fitted) {
  const RegressionMoments& m = fitted.moments;
  const double cxx = m.xx - m.x * m.x / m.weight, cyy = m.yy - m.y * m.y / m.weight;
  const double cxy = m.xy - m.x * m.y / m.weight;
  const double variance = kSharedErrors * fitted.squared_error / m.pixels;
  return std::sqrt(variance * (cxx + cyy) / (cxx * cyy - cxy * cxy));
}

std::uint32_t keyOf(int a, int b) {
  return static_cast<std::uint32_t>(std::min(a, b)) << 16 | static_cast<std::uint32_t>(std::max(a, b));
}

}  // namespace

// Adds the contact of clusters a and b.
void PlaneContinuation::addContact(const ViewRays& rays, const std::vector<PlaneCluster>& clusters, int a,
                                   int b, const ClusterContact& contact, int distance,
                                   const Tolerances& tolerances) {
  const CrossingCandidate &from = *contact.from, &to = *contact.to;
  const auto x_of = [&rays](int u) { return static_cast<double>(rays.x[u]); };
  const auto y_of = [&rays](int v) { return static_cast<double>(rays.y[v]); };
  const double x = 0.5 * (x_of(from.u) + x_of(to.u)), y = 0.5 * (y_of(from.v) + y_of(to.v));
  const InverseDepthPlane &plane = clusters[a].plane, &other = clusters[b].plane;
  const double gap = differenceAt(x, y, plane, other, tolerances.gap);
  const double rho = 0.5 * (plane.at(x, y) + other.at(x, y));
  contacts_.push_back({keyOf(a, b), static_cast<std::uint32_t>(contacts_.size()), 1, gap * gap, rho, {}});
  if (distance > kMaxContactDistance) return;
  const double step = stepAt(contact, plane, other, tolerances.step);
  contacts_.back().step.add(a < b ? step : -step);
}

// Whether the planes agree where they touch, without a step, and turn by no more than distortion and noise
// explain.
bool PlaneContinuation::isContinued(const PlaneCluster& small, const PlaneCluster& large,
                                    const Contact& contact) {
  if (contact.squared_gap > kMaxSquaredGap * contact.count || contact.step.isStep()) return false;
  const double turn = std::hypot(small.plane.a - large.plane.a, small.plane.b - large.plane.b);
  return turn <= kMaxTurn * contact.rho / contact.count + kSlopeDeviations * slopeDeviation(small);
}

// Makes one contact of all of the same two clusters.
void PlaneContinuation::sumContacts() {
  // Not a stable sort, which takes memory.
  std::sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
    return std::tie(a.clusters, a.order) < std::tie(b.clusters, b.order);
  });
  std::size_t kept = 0;
  for (const Contact& contact : contacts_) {
    if (kept == 0 || contacts_[kept - 1].clusters != contact.clusters) {
      contacts_[kept++] = contact;
      continue;
    }
    Contact& sum = contacts_[kept - 1];
    sum.count += contact.count;
    sum.squared_gap += contact.squared_gap;
    sum.rho += contact.rho;
    sum.step += contact.step;
  }
  contacts_.resize(kept);
}

void PlaneContinuation::listContacts(const ViewRays& rays, const CandidateGrid& grid,
                                     const std::vector<PlaneCluster>& clusters,
                                     const std::vector<int>& cluster_at, const Tolerances& tolerances) {
  contacts_.clear();
  // From each crossing to the next one with a cluster, one step of which leads to the right or down.
  const auto look = [&](int cell, int to_right, int below, int count) {
    const int step = grid.indexOf(to_right, below);
    for (int gap = 1; gap <= std::min(count, kMaxGap); ++gap) {
      const int other = cell + gap * step;
      const int a = cluster_at[cell], b = cluster_at[other];
      if (b < 0) continue;
      if (a == b) return;
      const ClusterContact contact = contactBetween(grid, cell, other, to_right, below,
                                                    [&cluster_at](int at) { return cluster_at[at]; });
      addContact(rays, clusters, a, b, contact, gap, tolerances);
      return;
    }
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const int cell = grid.indexOf(column, row);
      if (cluster_at[cell] < 0) continue;
      look(cell, 1, 0, grid.columns - 1 - column);
      look(cell, 0, 1, grid.rows - 1 - row);
    }
  }
  sumContacts();
}

void PlaneContinuation::find(const ViewRays& rays, const CandidateGrid& grid,
                             const std::vector<PlaneCluster>& clusters, const std::vector<int>& cluster_at,
                             const Parameters& parameters, std::vector<int>& plane_of) {
  const PatchParameters& patches = parameters.patches;
  listContacts(
      rays, grid, clusters, cluster_at,
      {{parameters.noise, patches.patch_noise_factor, patches.patch_distance}, stepTolerance(parameters)});
  const auto cluster = [&clusters](int i) -> const PlaneCluster& { return clusters[i]; };
  const auto is_larger = [&cluster](int a, int b) {
    return std::tuple(cluster(a).candidates, -a) > std::tuple(cluster(b).candidates, -b);
  };
  // First the neighbour that each one continues, the largest if there are several.
  plane_of.assign(clusters.size(), -1);
  for (const Contact& contact : contacts_) {
    int small = static_cast<int>(contact.clusters >> 16), large = static_cast<int>(contact.clusters & 0xFFFF);
    if (is_larger(small, large)) std::swap(small, large);
    if (!cluster(large).is_plane || !isContinued(cluster(small), cluster(large), contact)) continue;
    int& continued = plane_of[small];
    if (continued < 0 || is_larger(large, continued)) continued = large;
  }
  // Then the plane at the end of each chain.
  for (int i = 0; i < static_cast<int>(clusters.size()); ++i) {
    int end = i;
    for (int next = plane_of[end]; next >= 0 && next != end; next = plane_of[end]) end = next;
    if (cluster(end).is_plane) plane_of[i] = end;
  }
}

}  // namespace line_plane_segmentation
