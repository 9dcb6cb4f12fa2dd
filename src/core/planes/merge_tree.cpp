// SPDX-License-Identifier: BSD-3-Clause
#include "planes/merge_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernels/sparing_growth.h"
#include "planes/quadric_fit.h"

namespace line_plane_segmentation {
namespace {

// [limits] A pair of candidates may cost more than the clusters that they come to belong to, whose planes are
// better constrained, but not so much more.
constexpr double kHopeless = 4.0;
constexpr double kNever = std::numeric_limits<double>::max();

// So many comparisons are remembered, which saves time only. The factor spreads candidates that are
// neighbours in a row, whose indices follow each other.
constexpr std::size_t kComparisons = 1024, kHashFactor = 618;

// Two clusters are two planes if, for each candidate of the smaller one, the common surface adds more squared
// deviation than this multiple of the variance about their own planes. With equal halves, 2 doubles the
// variance. Its basis: variance ratio test (F test) with the threshold of an effect, not of significance,
// since sensor distortion makes any deviation significant over enough candidates.
constexpr double kTwoPlanes = 2.0;
constexpr std::size_t kEnoughPoints = 128;  // of a quadric: so many are sampled of more
constexpr double kVarianceFloor = 0.05;     // [tolerance²] deviations below it do not count

RegressionMoments momentsOfMean(const CrossingCandidate& candidate) {
  const double x = candidate.x, y = candidate.y, rho = candidate.rho;
  const double weight = candidate.inv_tolerance * candidate.inv_tolerance;
  RegressionMoments moments{x * x, x * y, y * y, x, y, 1.0, x * rho, y * rho, rho, rho * rho, 1.0};
  moments.scale(weight);
  return moments;
}

double squaredError(const RegressionMoments& means) {
  InverseDepthPlane plane;
  double squared_error = 0.0;
  return means.fit(plane, squared_error) ? squared_error : 0.0;
}

double varianceOf(const RegressionMoments& means, int candidates) {
  return candidates < 4 ? 0.0 : squaredError(means) / (candidates - 3);
}

}  // namespace

void MergeTree::start(const CandidateGrid& grid, const DepthTolerance& step_tolerance) {
  grid_ = &grid;
  step_tolerance_ = step_tolerance;
  const std::vector<CrossingCandidate>& candidates = grid.candidates;
  size_ = leaves_ = static_cast<int>(candidates.size());
  if (nodes_.size() < 2 * candidates.size()) {
    resizeAnew(2 * candidates.size(), nodes_);
    resizeAnew(2 * candidates.size(), parent_);
  }
  next_.assign(candidates.size(), -1);
  means_.clear();
  for (int i = 0; i < leaves_; ++i) {
    Node& node = nodes_[i];
    static_cast<FittedPixels&>(node) = candidates[i];
    node.left = node.right = node.means_index = -1;
    node.candidates = 1;
    node.first = node.last = parent_[i] = i;
  }
}

bool MergeTree::combine(int a, int b, FittedPixels& both) const {
  both.moments = node(a).moments + node(b).moments;
  return both.moments.fit(both.plane, both.squared_error);
}

double MergeTree::costOf(int a, int b, const FittedPixels& both) const {
  const Node &first = node(a), &second = node(b);
  return (both.squared_error - first.squared_error - second.squared_error) /
         std::min(first.moments.pixels, second.moments.pixels);
}

int MergeTree::merge(int a, int b, const FittedPixels& both) {
  // Only parts of clusters, which are merged once more, can need more room than there is.
  if (size_ == static_cast<int>(nodes_.size())) {
    nodes_.emplace_back();
    parent_.emplace_back();
  }
  const int merged = size_++;
  const Node &first = node(a), &second = node(b);
  Node& node = nodes_[merged];
  if (&both != &node) static_cast<FittedPixels&>(node) = both;
  node.candidates = first.candidates + second.candidates;
  node.means_index = -1;
  node.left = a;
  node.right = b;
  node.first = first.first;
  node.last = second.last;
  next_[first.last] = second.first;
  parent_[a] = parent_[b] = parent_[merged] = merged;
  if (node.candidates >= kMinCompared) {
    node.means_index = static_cast<int>(means_.size());
    reserveSparingly(means_.size() + 1, means_);
    means_.push_back(means(a) + means(b));
  }
  return merged;
}

RegressionMoments MergeTree::means(int i) const {
  const Node& n = node(i);
  if (n.means_index >= 0) return means_[n.means_index];
  RegressionMoments sum;
  for (int k = n.first;; k = next_[k]) {
    sum += momentsOfMean(grid_->candidates[k]);
    if (k == n.last) return sum;
  }
}

double MergeTree::variance(int i) const { return varianceOf(means(i), node(i).candidates); }

double MergeTree::varianceOfBoth(int a, int b) const {
  return varianceOf(means(a) + means(b), node(a).candidates + node(b).candidates);
}

void MergeTree::appendCandidates(int i) {
  const int last = node(i).last;
  int candidate = node(i).first;
  listed_.push_back(candidate);
  while (candidate != last) listed_.push_back(candidate = next_[candidate]);
}

const std::vector<int>& MergeTree::candidatesOf(int i) {
  listed_.clear();
  appendCandidates(i);
  return listed_;
}

// Variance of the listed candidates about their quadric surface, from their deviations from any plane.
double MergeTree::quadricVarianceOfListed(const InverseDepthPlane& plane) {
  QuadricFit quadric;
  const std::size_t stride = (listed_.size() + kEnoughPoints - 1) / kEnoughPoints;
  for (std::size_t k = 0; k < listed_.size(); k += stride) {
    const CrossingCandidate& candidate = grid_->candidates[listed_[k]];
    quadric.add(candidate.x, candidate.y, candidate.deviationFrom(plane) * candidate.inv_tolerance);
  }
  return quadric.points() > 6 ? quadric.variance() : 0.0;
}

// The same of two clusters.
double MergeTree::quadricVarianceOfBoth(int a, int b, const InverseDepthPlane& plane) {
  listed_.clear();
  appendCandidates(a);
  appendCandidates(b);
  return quadricVarianceOfListed(plane);
}

double MergeTree::quadricVariance(int i) {
  candidatesOf(i);
  return quadricVarianceOfListed(node(i).plane);
}

// The root above the candidate at a crossing, -1 if there is none.
int MergeTree::clusterAt(int cell) {
  const int candidate = cell < 0 ? -1 : grid_->candidate_at[cell];
  return candidate < 0 ? -1 : find(candidate);
}

// Adds the steps from a candidate of the root a to those of the root b that come next on its scanlines.
// Between them may be one that belongs to neither, since its windows lie across the border.
void MergeTree::addContacts(int candidate, int a, int b, MeanStep& steps) {
  static constexpr std::array<std::array<int, 2>, 4> kDirections = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const int from = grid_->candidates[candidate].cell;
  for (const auto& [right, down] : kDirections) {
    int to = -1, cluster = -1;
    for (int distance = 1; distance <= kMaxContactDistance && cluster != a && cluster != b; ++distance) {
      to = grid_->cellBeside(from, right * distance, down * distance);
      cluster = clusterAt(to);
    }
    if (cluster != b) continue;
    const ClusterContact contact =
        contactBetween(*grid_, from, to, right, down, [this](int cell) { return clusterAt(cell); });
    steps.add(stepAt(contact, node(a).plane, node(b).plane, step_tolerance_));
  }
}

// Whether there is a step in depth where the clusters of two roots meet.
bool MergeTree::hasStep(int a, int b) {
  const bool is_a_smaller = node(a).candidates <= node(b).candidates;
  const int smaller = is_a_smaller ? a : b, larger = is_a_smaller ? b : a;
  MeanStep steps;
  for (const int candidate : candidatesOf(smaller)) addContacts(candidate, smaller, larger, steps);
  return steps.isStep();
}

bool MergeTree::isTwoPlanes(int a, int b, const FittedPixels& both) {
  const Node &first = node(a), &second = node(b);
  const int fewer = std::min(first.candidates, second.candidates);
  const int degrees_of_freedom = first.candidates + second.candidates - 6;
  if (fewer < kMinCompared) return false;
  const RegressionMoments first_means = means(a), second_means = means(b);
  const double common = squaredError(first_means + second_means);
  const double apart = squaredError(first_means) + squaredError(second_means);
  const double bound = kTwoPlanes * (apart / degrees_of_freedom + kVarianceFloor) * fewer;
  if (common - apart < bound) return false;
  // Distortion bends planes smoothly, as a quadric does. But a quadric may explain a step as well.
  return quadricVarianceOfBoth(a, b, both.plane) * degrees_of_freedom - apart >= bound || hasStep(a, b);
}

bool MergeTree::isPieceOfCurved(int piece, int rest) {
  const Node &first = node(piece), &second = node(rest);
  if (second.candidates < std::max(kMinCompared, first.candidates)) return false;
  const int candidates = first.candidates + second.candidates;
  const RegressionMoments piece_means = means(piece);
  const double about_plane = squaredError(piece_means + means(rest));
  const double about_quadric = quadricVarianceOfBoth(piece, rest, second.plane) * (candidates - 6);
  const double apart = squaredError(piece_means) + quadricVariance(rest) * (second.candidates - 6);
  const double bound = (apart / candidates + kVarianceFloor) * first.candidates;
  return about_quadric - apart < bound && about_quadric < kMaxResidualRatio * about_plane;
}

// Where the comparison of two roots is remembered: two large clusters have many links, which all ask for it.
MergeTree::Comparison& MergeTree::comparisonOf(int a, int b) {
  return comparisons_[(static_cast<std::size_t>(a) * kHashFactor + static_cast<std::size_t>(b)) %
                      kComparisons];
}

// Merges the clusters of linked candidates if that costs less than the limit of this round.
// @return whether they may be merged later, since it costs at most `hopeless`
bool MergeTree::compare(const CandidateGrid::Link& link, double limit, double hopeless) {
  // The newer one first: samples of the candidates, and so isTwoPlanes(), depend on the order.
  const auto [b, a] = std::minmax({find(link.a), find(link.b)});
  if (a == b) return false;
  Comparison& known = comparisonOf(a, b);
  if (known.a == a && known.b == b && !(known.cost < limit)) return known.cost <= hopeless;
  FittedPixels& both = nodes_[size_];
  const double cost = combine(a, b, both) ? costOf(a, b, both) : kNever;
  if (cost < limit && !isTwoPlanes(a, b, both)) {
    merge(a, b, both);
    return false;
  }
  // Two planes are compared again when either cluster has changed.
  known = {a, b, cost < limit ? hopeless : cost};
  return known.cost <= hopeless;
}

void MergeTree::mergeLinked(const std::vector<CandidateGrid::Link>& links, double limit,
                            std::initializer_list<double> rounds) {
  links_ = links;
  comparisons_.assign(kComparisons, {});
  for (const double fraction : rounds) {
    std::size_t kept = 0;
    for (const CandidateGrid::Link& link : links_) {
      if (compare(link, fraction * limit, kHopeless * limit)) links_[kept++] = link;
    }
    links_.resize(kept);
  }
}

}  // namespace line_plane_segmentation
