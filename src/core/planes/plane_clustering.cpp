// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_clustering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxClusters = 65534;  // 16-bit labels; 65535 marks invalid depth

// Residual sensor distortion bends a plane smoothly, so that its deviation grows with the square of its
// extent and the mean square with the square of the fraction of the image that it covers. At this fraction
// the bounds for small planes are doubled, at a smaller one if distortion is measured to be larger.
constexpr double kDistortedFraction = 0.045;

// A plane with fewer candidates than this across it, on average, is narrow: most of their windows end at its
// borders.
constexpr double kMinScanlines = 3.0;

// Links between a piece of a curved surface and the rest: fewer are where two surfaces touch by chance.
constexpr std::size_t kMinLinks = 3;

// A narrower plane beside a surface that is none is part of it: at the silhouette of a pillar, one column of
// candidates is nearly flat.
constexpr double kStrip = 2.0;

// So few candidates leave most of a plane's pixels out.
constexpr std::size_t kFewCandidates = 28;

// The number of candidates across the longer side of the rectangle around them, on average. A slanted strip
// spans many of both sides, but fills little of them.
double widthOf(const std::vector<int>& candidates, const CandidateGrid& grid) {
  int first_column = grid.columns, last_column = 0, first_row = grid.rows, last_row = 0;
  for (const int i : candidates) {
    const int cell = grid.candidates[i].cell;
    const int column = cell % grid.columns, row = cell / grid.columns;
    first_column = std::min(first_column, column);
    last_column = std::max(last_column, column);
    first_row = std::min(first_row, row);
    last_row = std::max(last_row, row);
  }
  const int length = std::max(last_column - first_column, last_row - first_row) + 1;
  return static_cast<double>(candidates.size()) / length;
}

bool isNarrow(const std::vector<int>& candidates, const CandidateGrid& grid) {
  return candidates.size() < kFewCandidates || widthOf(candidates, grid) < kMinScanlines;
}

double allowDistortion(double bound, double fraction) {
  const double relative = fraction / kDistortedFraction;
  return bound * (1.0 + relative * relative);
}

}  // namespace

bool PlaneClusterer::isPlane(int i, double fraction, const ClusterParameters& parameters) {
  const MergeTree::Node& node = tree_.node(i);
  if (node.squared_error > allowDistortion(parameters.max_curvedness, fraction) * node.moments.pixels)
    return false;
  const double variance = tree_.variance(i);
  if (variance > allowDistortion(parameters.max_waviness, fraction)) return false;
  if (node.candidates < kMinCompared) return true;
  const double max_bend = allowDistortion(parameters.max_bend, fraction);
  if (!(variance > max_bend)) return true;
  const double about_quadric = tree_.quadricVariance(i);
  return !(variance - about_quadric > max_bend && about_quadric < kMaxResidualRatio * variance);
}

// Adds those parts of a cluster that are planes, the largest in each branch of its tree.
void PlaneClusterer::addParts(int root, double fraction_per_candidate, int min_candidates,
                              const ClusterParameters& parameters) {
  parts_ = {tree_.node(root).right, tree_.node(root).left};
  while (!parts_.empty()) {
    const int part = parts_.back();
    parts_.pop_back();
    const MergeTree::Node& node = tree_.node(part);
    if (node.candidates < min_candidates) continue;
    if (isPlane(part, node.candidates * fraction_per_candidate, parameters)) {
      planes_.push_back(part);
    } else if (part >= tree_.leaves()) {
      parts_.push_back(node.right);
      parts_.push_back(node.left);
    }
  }
}

void PlaneClusterer::addPlanes(int root, double fraction_per_candidate, int min_candidates,
                               const ClusterParameters& parameters) {
  if (root < tree_.leaves()) return;  // no neighbour confirms a single candidate
  const MergeTree::Node& node = tree_.node(root);
  if (isPlane(root, node.candidates * fraction_per_candidate, parameters)) {
    planes_.push_back(root);
    return;
  }
  const std::size_t before = planes_.size();
  addParts(root, fraction_per_candidate, min_candidates, parameters);
  int candidates = 0;
  double squares = 0.0;
  for (std::size_t k = before; k < planes_.size(); ++k) {
    const int part = tree_.node(planes_[k]).candidates;
    candidates += part;
    squares += part * tree_.variance(planes_[k]);
  }
  const bool are_most = 2 * candidates >= node.candidates;
  if (!are_most || tree_.quadricVariance(root) * candidates < squares) planes_.resize(before);
  if (planes_.size() == before) others_.push_back(root);
}

// Drops planes that are pieces of a curved surface: the smaller of two neighbours, and the larger one if both
// together are bent more than distortion bends so large a plane.
void PlaneClusterer::dropPiecesOfCurved(const CandidateGrid& grid, double fraction_per_candidate,
                                        const ClusterParameters& parameters) {
  owner_.assign(grid.candidates.size(), -1);
  for (const std::vector<int>* nodes : {&planes_, &others_}) {
    for (const int node : *nodes) {
      for (const int candidate : tree_.candidatesOf(node)) owner_[candidate] = node;
    }
  }
  const auto find = [this](int node) { return std::find(planes_.begin(), planes_.end(), node); };
  const auto is_plane = [&](int node) { return find(node) != planes_.end(); };
  const auto drop = [&](int node) {
    const auto plane = find(node);
    if (plane == planes_.end()) return;
    planes_.erase(plane);
    others_.push_back(node);
  };
  neighbors_.clear();
  for (const CandidateGrid::Link& link : grid.links) {
    const int a = owner_[link.a], b = owner_[link.b];
    if (a < 0 || b < 0 || a == b) continue;
    const bool is_a_smaller = tree_.node(a).candidates < tree_.node(b).candidates;
    const auto [small, large] = is_a_smaller ? std::pair(a, b) : std::pair(b, a);
    // Others are no pieces of a curved surface: a short list is sorted sooner.
    if (tree_.node(small).candidates >= parameters.min_patches &&
        tree_.node(large).candidates >= kMinCompared)
      neighbors_.push_back({small, large});
  }
  std::sort(neighbors_.begin(), neighbors_.end());
  for (std::size_t first = 0, last = 0; first < neighbors_.size(); first = last) {
    while (last < neighbors_.size() && neighbors_[last] == neighbors_[first]) ++last;
    const auto [small, large] = neighbors_[first];
    if (last - first < kMinLinks || !(is_plane(small) || is_plane(large))) continue;
    if (!tree_.isPieceOfCurved(small, large)) continue;
    drop(small);
    const int candidates = tree_.node(small).candidates + tree_.node(large).candidates;
    const double max_bend = allowDistortion(parameters.max_bend, candidates * fraction_per_candidate);
    if (tree_.varianceOfBoth(small, large) > max_bend) drop(large);
  }
  // Then the strips beside what is no plane by now: a strip that goes drops none beside it.
  strips_.clear();
  for (std::size_t first = 0, last = 0; first < neighbors_.size(); first = last) {
    while (last < neighbors_.size() && neighbors_[last] == neighbors_[first]) ++last;
    const auto [small, large] = neighbors_[first];
    if (last - first < kMinLinks || !is_plane(small) || is_plane(large)) continue;
    if (widthOf(tree_.candidatesOf(small), grid) < kStrip) strips_.push_back(small);
  }
  for (const int strip : strips_) drop(strip);
}

void PlaneClusterer::cluster(const DepthImage& depth, const ViewRays& rays, const CandidateGrid& grid,
                             const Parameters& parameters, double distortion,
                             std::vector<PlaneCluster>& clusters, std::vector<int>& cluster_at) {
  tree_.start(grid, stepTolerance(parameters));
  tree_.mergeLinked(grid.links, parameters.clusters.merge_cost,
                    {1.0 / 64, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0});

  // A part has to be large enough for the smallest plane: as many crossings as that has pixels.
  const double pixels_per_crossing = static_cast<double>(grid.spacing) * grid.spacing;
  const int min_candidates =
      std::max(parameters.clusters.min_patches,
               static_cast<int>(std::lround(parameters.extraction.min_plane_inliers / pixels_per_crossing)));
  planes_.clear();
  others_.clear();
  const double distorted_fraction = distortion * grid.fractionPerCandidate();
  for (int i = 0; i < tree_.size(); ++i) {
    if (tree_.isRoot(i)) addPlanes(i, distorted_fraction, min_candidates, parameters.clusters);
  }
  dropPiecesOfCurved(grid, distorted_fraction, parameters.clusters);
  coplanar_merger_.merge(depth, rays, grid, parameters, tree_, planes_);

  clusters.clear();
  cluster_at.assign(grid.candidate_at.size(), -1);
  // Small clusters are removed after merging, because objects in front divide a plane into small parts.
  for (const bool is_plane : {true, false}) {
    for (const int node : is_plane ? planes_ : others_) {
      if (tree_.node(node).candidates >= parameters.clusters.min_patches)
        addCluster(node, is_plane, grid, clusters, cluster_at);
    }
  }
}

void PlaneClusterer::addCluster(int i, bool is_plane, const CandidateGrid& grid,
                                std::vector<PlaneCluster>& clusters, std::vector<int>& cluster_at) {
  if (clusters.size() == kMaxClusters) return;
  const std::vector<int>& candidates = tree_.candidatesOf(i);
  for (const int candidate : candidates) {
    const int cell = grid.candidates[candidate].cell;
    cluster_at[cell] = static_cast<int>(clusters.size());
  }
  const MergeTree::Node& node = tree_.node(i);
  clusters.push_back(
      {node, node.candidates, tree_.means(i), is_plane, is_plane && isNarrow(candidates, grid)});
}

}  // namespace line_plane_segmentation
