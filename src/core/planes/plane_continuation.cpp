// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_continuation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace line_plane_segmentation {
namespace {

// Largest number of crossings from one cluster to the other: distortion widens the gap between them.
constexpr int kMaxGap = 4;

// [tolerance²] mean square by which the planes may differ where the clusters meet: two tolerances.
constexpr double kMaxSquaredGap = 4.0;

// [-] change of relative depth per unit of the tangent of the view angle: 0.2 is the turn of a surface seen
// from the front by 11 degrees, and 2 % of depth over 57 of 640 pixels, what Kinects show near the corners.
constexpr double kMaxTurn = 0.2;

// A slope is uncertain by so many standard deviations (95 %).
constexpr double kSlopeDeviations = 2.0;

// Contacts of a border: a few, and as many as half of the side of a square of the smaller cluster's size.
constexpr int kMinContacts = 3;

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

void PlaneContinuation::addContact(const ViewRays& rays, const CandidateGrid& grid,
                                   const std::vector<PlaneCluster>& clusters, const DepthTolerance& tolerance,
                                   int cell, int other_cell) {
  const auto cluster_at = [this](int i) { return cluster_at_[static_cast<std::size_t>(i)]; };
  const auto candidate_at = [&grid](int i) -> const CrossingCandidate& {
    return grid.candidates[static_cast<std::size_t>(grid.candidate_at[static_cast<std::size_t>(i)])];
  };
  const int a = cluster_at(cell), b = cluster_at(other_cell);
  if (a == b || a < 0 || b < 0) return;
  const CrossingCandidate &from = candidate_at(cell), &to = candidate_at(other_cell);
  const auto x_of = [&rays](int u) { return static_cast<double>(rays.x[static_cast<std::size_t>(u)]); };
  const auto y_of = [&rays](int v) { return static_cast<double>(rays.y[static_cast<std::size_t>(v)]); };
  const double x = 0.5 * (x_of(from.u) + x_of(to.u)), y = 0.5 * (y_of(from.v) + y_of(to.v));
  const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(a)].plane;
  const double rho = plane.at(x, y), other_rho = clusters[static_cast<std::size_t>(b)].plane.at(x, y);
  const double mean = 0.5 * (rho + other_rho);
  const double gap = (rho - other_rho) / tolerance.at(mean, plane.inverseDistance());
  const std::uint32_t order = static_cast<std::uint32_t>(contacts_.size());
  contacts_.push_back({keyOf(a, b), order, 1, gap * gap, mean});
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
  }
  contacts_.resize(kept);
}

void PlaneContinuation::find(const ViewRays& rays, const CandidateGrid& grid,
                             const std::vector<PlaneCluster>& clusters, const std::vector<int>& cluster_of,
                             const Parameters& parameters, std::vector<int>& plane_of) {
  cluster_at_.assign(grid.candidate_at.size(), -1);
  for (std::size_t i = 0; i < grid.candidates.size(); ++i)
    cluster_at_[static_cast<std::size_t>(grid.candidates[i].cell)] = cluster_of[i];
  const DepthTolerance tolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                 parameters.patches.patch_distance};
  contacts_.clear();
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const int cell = grid.indexOf(column, row);
      if (cluster_at_[static_cast<std::size_t>(cell)] < 0) continue;
      for (int gap = 1; gap <= kMaxGap; ++gap) {
        if (column + gap < grid.columns) addContact(rays, grid, clusters, tolerance, cell, cell + gap);
        if (row + gap < grid.rows)
          addContact(rays, grid, clusters, tolerance, cell, cell + gap * grid.columns);
      }
    }
  }
  sumContacts();

  const auto cluster = [&clusters](int i) -> const PlaneCluster& {
    return clusters[static_cast<std::size_t>(i)];
  };
  const auto is_larger = [&cluster](int a, int b) {
    return std::tuple(cluster(a).candidates, -a) > std::tuple(cluster(b).candidates, -b);
  };
  // First the neighbour that each one continues, the largest if there are several.
  plane_of.assign(clusters.size(), -1);
  for (const Contact& contact : contacts_) {
    int small = static_cast<int>(contact.clusters >> 16), large = static_cast<int>(contact.clusters & 0xFFFF);
    if (is_larger(small, large)) std::swap(small, large);
    if (!cluster(large).is_plane) continue;
    if (contact.count < kMinContacts || 4 * contact.count * contact.count < cluster(small).candidates)
      continue;
    if (contact.squared_gap > kMaxSquaredGap * contact.count) continue;
    const double turn = std::hypot(cluster(small).plane.a - cluster(large).plane.a,
                                   cluster(small).plane.b - cluster(large).plane.b);
    const double rho = contact.rho / contact.count;
    if (turn > kMaxTurn * rho + kSlopeDeviations * slopeDeviation(cluster(small))) continue;
    int& continued = plane_of[static_cast<std::size_t>(small)];
    if (continued < 0 || is_larger(large, continued)) continued = large;
  }
  // Then the plane at the end of each chain, from the largest cluster down.
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    int end = static_cast<int>(i);
    while (plane_of[static_cast<std::size_t>(end)] >= 0 && plane_of[static_cast<std::size_t>(end)] != end)
      end = plane_of[static_cast<std::size_t>(end)];
    if (cluster(end).is_plane) plane_of[i] = end;
  }
}

}  // namespace line_plane_segmentation
