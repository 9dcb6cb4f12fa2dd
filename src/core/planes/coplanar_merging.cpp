// SPDX-License-Identifier: BSD-3-Clause
#include "planes/coplanar_merging.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <tuple>

#include "planes/depth_step.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxPlanes = 64;  // all pairs of the largest ones are compared: bounds the time

constexpr int kMaxSamples = 64;  // of the line between two planes: a quarter is 16 of them

}  // namespace

// Whether less than a quarter of the straight line between two candidates is behind the plane.
bool CoplanarMerger::isOccludedBetween(Pixel from, Pixel to, const InverseDepthPlane& plane,
                                       const DepthImage& depth, const ViewRays& rays,
                                       const Parameters& parameters) {
  const double inverse_distance = plane.inverseDistance();
  const DepthTolerance tolerance{parameters.noise, 2.0 * parameters.extraction.distance_noise_factor,
                                 2.0 * parameters.extraction.plane_distance};
  const int du = to.u - from.u, dv = to.v - from.v;
  const int steps = std::min(std::max(std::abs(du), std::abs(dv)), kMaxSamples);
  int behind = 0;
  for (int k = 0; k < steps; ++k) {
    const int u = from.u + du * k / steps, v = from.v + dv * k / steps;
    const float z = depth.at(u, v);
    if (!(z > 0.0F)) continue;
    const double rho = 1.0 / static_cast<double>(z);
    const double expected = plane.at(static_cast<double>(rays.x[u]), static_cast<double>(rays.y[v]));
    if (!(expected - rho > tolerance.at(rho, inverse_distance))) continue;
    if (4 * ++behind >= steps) return false;
  }
  return 4 * behind < steps;
}

// Whether two planes are at the same depth halfway between two of their candidates.
bool CoplanarMerger::isSameDepthBetween(Pixel from, Pixel to, const InverseDepthPlane& plane,
                                        const InverseDepthPlane& other, const ViewRays& rays,
                                        const DepthTolerance& tolerance) {
  const double x = 0.5 * (static_cast<double>(rays.x[from.u]) + static_cast<double>(rays.x[to.u]));
  const double y = 0.5 * (static_cast<double>(rays.y[from.v]) + static_cast<double>(rays.y[to.v]));
  return std::fabs(differenceAt(x, y, plane, other, tolerance)) < 1.0;
}

void CoplanarMerger::listPairs(const MergeTree& tree, const std::vector<int>& planes, double limit) {
  pairs_.clear();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      FittedPixels both;
      if (!tree.combine(planes[i], planes[j], both)) continue;
      const double cost = tree.costOf(planes[i], planes[j], both);
      if (cost < limit) pairs_.push_back({cost, static_cast<int>(i), static_cast<int>(j)});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& p, const Pair& q) {
    return std::tie(p.cost, p.a, p.b) < std::tie(q.cost, q.a, q.b);
  });
}

// Returns the pixel that is nearest to another one. There is at least one.
CoplanarMerger::Pixel CoplanarMerger::nearest(const std::vector<Pixel>& pixels, Pixel to) {
  Pixel nearest = pixels.front();
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const Pixel& pixel : pixels) {
    const std::int64_t du = pixel.u - to.u, dv = pixel.v - to.v;
    if (du * du + dv * dv >= least) continue;
    nearest = pixel;
    least = du * du + dv * dv;
  }
  return nearest;
}

void CoplanarMerger::mergePairs(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters,
                                MergeTree& tree) {
  const double limit = parameters.clusters.coplanar_cost;
  const DepthTolerance step_tolerance = stepTolerance(parameters);
  const auto find = [this](int i) {
    while (merged_into_[i] != i) i = merged_into_[i];
    return i;
  };
  for (const Pair& pair : pairs_) {
    const int a = find(pair.a), b = find(pair.b);
    // Planes that have grown together meet again for each pair of their parts.
    if (a == b || rejected_[indexOf(a, b)] != 0) continue;
    rejected_[indexOf(a, b)] = 1;
    int& first = compared_[a];
    const int second = compared_[b];
    FittedPixels both;
    if (!tree.combine(first, second, both) || !(tree.costOf(first, second, both) < limit)) continue;
    const Pixel from = nearest(pixels_[a], pixels_[b].front());
    const Pixel to = nearest(pixels_[b], from);
    if (!isSameDepthBetween(from, to, tree.node(first).plane, tree.node(second).plane, rays, step_tolerance))
      continue;
    if (!isOccludedBetween(from, to, both.plane, depth, rays, parameters)) continue;
    first = tree.merge(first, second, both);
    merged_into_[b] = a;
    for (std::size_t i = 0; i < compared_.size(); ++i)
      rejected_[indexOf(static_cast<int>(i), a)] = rejected_[indexOf(a, static_cast<int>(i))] = 0;
    std::vector<Pixel>& all = pixels_[a];
    const std::vector<Pixel>& more = pixels_[b];
    all.insert(all.end(), more.begin(), more.end());
  }
}

void CoplanarMerger::merge(const DepthImage& depth, const ViewRays& rays, const CandidateGrid& grid,
                           const Parameters& parameters, MergeTree& tree, std::vector<int>& planes) {
  const double limit = parameters.clusters.coplanar_cost;
  if (!(limit > 0.0) || planes.size() < 2) return;
  // The largest first; those beyond the limit are not compared.
  std::sort(planes.begin(), planes.end(), [&tree](int a, int b) {
    const int more = tree.node(a).candidates, fewer = tree.node(b).candidates;
    return more != fewer ? more > fewer : a < b;
  });
  std::vector<int>& compared = compared_;
  compared.assign(planes.begin(),
                  planes.begin() + static_cast<std::ptrdiff_t>(std::min(kMaxPlanes, planes.size())));
  listPairs(tree, compared, limit);
  if (pairs_.empty()) return;

  pixels_.resize(std::max(pixels_.size(), compared.size()));
  merged_into_.clear();
  for (std::size_t i = 0; i < compared.size(); ++i) {
    merged_into_.push_back(static_cast<int>(i));
    pixels_[i].clear();
    for (const int c : tree.candidatesOf(compared[i]))
      pixels_[i].push_back({grid.candidates[c].u, grid.candidates[c].v});
  }
  rejected_.assign(compared.size() * compared.size(), 0);
  mergePairs(depth, rays, parameters, tree);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (i >= compared.size())
      planes[kept++] = planes[i];
    else if (merged_into_[i] == static_cast<int>(i))
      planes[kept++] = compared[i];
  }
  planes.resize(kept);
}

}  // namespace line_plane_segmentation
