// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "planes/crossing_candidates.h"
#include "planes/depth_step.h"

namespace line_plane_segmentation {

/// A surface is curved if a quadric surface leaves less than this fraction of its variance about a plane.
constexpr double kMaxResidualRatio = 0.25;

/// Fewest candidates of a cluster that is compared with another surface: a plane has three parameters, a
/// quadric six.
constexpr int kMinCompared = 8;

/// Agglomerative clustering of plane candidates with the history of its merges: a binary tree (dendrogram)
/// whose leaves are the candidates. A disjoint-set forest (union-find) over the nodes finds a node's root.
///
/// The cost of a merge is the squared error that it adds, divided by the pixels of the smaller cluster
/// [tolerance²]: the mean square by which the smaller cluster's pixels are moved off their own plane.
class MergeTree {
 public:
  /// A cluster. Leaves come first, in the order of the candidates.
  struct Node : FittedPixels {
    int left = -1, right = -1;  ///< the clusters merged into this one, -1 for leaves
    int first = -1, last = -1;  ///< ends of its candidates' list
    int candidates = 0;
    int means_index = -1;  ///< see MergeTree::means(); -1 if they are not stored
  };

  /// Starts with one cluster for each candidate. The grid is read until the next start.
  void start(const CandidateGrid& grid, const DepthTolerance& step_tolerance);

  int size() const { return size_; }
  int leaves() const { return leaves_; }
  const Node& node(int i) const { return nodes_[i]; }
  bool isRoot(int i) const { return parent_[i] == i; }

  /// The root above a node.
  int find(int i) {
    while (parent_[i] != i) {
      int& parent = parent_[i];
      parent = parent_[parent];
      i = parent;
    }
    return i;
  }

  /// Merges the clusters of linked candidates that cost less than `limit`, those that cost least first:
  /// in rounds, each with a fraction of the limit. Two clusters that are two planes, by isTwoPlanes(), are
  /// not merged.
  void mergeLinked(const std::vector<CandidateGrid::Link>& links, double limit,
                   std::initializer_list<double> rounds);

  /// The cluster that merging two roots would make.
  /// @return false if its pixels are degenerate
  bool combine(int a, int b, FittedPixels& both) const;

  /// The cost of merging two roots into `both` [tolerance²].
  double costOf(int a, int b, const FittedPixels& both) const;

  /// Appends a merged cluster and returns its index. Parts of clusters may be merged once more.
  int merge(int a, int b, const FittedPixels& both);

  /// Whether two planes explain the candidates of two clusters much better than one plane, and there is a
  /// step between them or a quadric surface does not explain them either. False if either has fewer than 8
  /// candidates.
  bool isTwoPlanes(int a, int b, const FittedPixels& both);

  /// Moments of the candidates' mean points, each weighed by 1 / tolerance²: averaging over a candidate's
  /// pixels shows deviations that the noise of single pixels hides. Stored for clusters that can be compared,
  /// of at least 8 candidates, and summed anew for smaller ones.
  RegressionMoments means(int i) const;

  /// Variance of the candidates' mean points about their common plane [tolerance²]; 0 if there are fewer
  /// than 4, or they are degenerate.
  double variance(int i) const;

  /// The same of the candidates of two clusters.
  double varianceOfBoth(int a, int b) const;

  /// The same about their common quadric surface; 0 if there are fewer than 7.
  double quadricVariance(int i);

  /// Whether a cluster is a piece of a curved surface of which another cluster is the rest: one quadric
  /// surface explains both as well as a plane explains the piece and a quadric the rest, to the mean variance
  /// for each candidate of the piece, and much better than a common plane does. False if the rest has fewer
  /// candidates than the piece, or fewer than 8.
  bool isPieceOfCurved(int piece, int rest);

  /// The candidates of a cluster, those of its left part first.
  const std::vector<int>& candidatesOf(int i);

 private:
  /// Two roots, a > b, and the cost of merging them. It never changes: a merge makes a new root.
  struct Comparison {
    int a = -1, b = -1;
    double cost = 0.0;  ///< [tolerance²]
  };

  void appendCandidates(int i);
  int clusterAt(int cell);
  void addContacts(int candidate, int a, int b, MeanStep& steps);
  bool hasStep(int a, int b);
  double quadricVarianceOfBoth(int a, int b, const InverseDepthPlane& plane);
  double quadricVarianceOfListed(const InverseDepthPlane& plane);
  Comparison& comparisonOf(int a, int b);
  bool compare(const CandidateGrid::Link& link, double limit, double hopeless);

  const CandidateGrid* grid_ = nullptr;
  DepthTolerance step_tolerance_;
  std::vector<Node> nodes_;  // room for all merges; the next one is tried behind the last node
  std::vector<int> parent_;
  std::vector<RegressionMoments> means_;
  int size_ = 0, leaves_ = 0;
  std::vector<CandidateGrid::Link> links_;  // between candidates that may still be merged
  std::vector<Comparison> comparisons_;     // the last ones, by a hash of the roots
  std::vector<int> next_;                   // candidate after each one; those of every node follow each other
  std::vector<int> listed_;
};

}  // namespace line_plane_segmentation
