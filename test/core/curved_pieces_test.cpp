// SPDX-License-Identifier: BSD-3-Clause
// The variances of clusters of candidates, and when a cluster is a piece of a curved surface; the rest of
// merge_tree.h and of plane_clustering.h is tested in merge_tree_test.cpp and plane_clustering_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "planes/merge_tree.h"
#include "planes/plane_clustering.h"
#include "support/made_candidates.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// Merges candidates to one cluster.
int mergeAll(int first, int end, MergeTree& tree) {
  int merged = first;
  for (int i = first + 1; i < end; ++i) {
    FittedPixels both;
    tree.combine(merged, i, both);
    merged = tree.merge(merged, i, both);
  }
  return merged;
}

struct Variances {
  double about_plane, about_quadric;
};

/// The variances of a cluster whose candidates fill rows of a grid, and deviate by 1 to either side in turn.
Variances variancesOf(int columns, int candidates) {
  MadeCandidates made(columns, candidates);
  for (int i = 0; i < candidates; ++i) {
    const int column = i % columns, row = i / columns;
    made.add(column, row, 1000.0 + ((column + row) % 2 == 0 ? 1.0 : -1.0));
  }
  MergeTree tree;
  tree.start(made, {});
  const int cluster = mergeAll(0, candidates, tree);
  return {tree.variance(cluster), tree.quadricVariance(cluster)};
}

TEST(VarianceOfACluster, IsPerDegreeOfFreedom) {
  EXPECT_EQ(variancesOf(2, 3).about_plane, 0.0) << "a plane has three parameters";
  EXPECT_NEAR(variancesOf(2, 4).about_plane, 4.0, 1e-6);
  EXPECT_EQ(variancesOf(3, 6).about_quadric, 0.0) << "a quadric surface has six parameters";
  EXPECT_NEAR(variancesOf(3, 9).about_quadric, 64.0 / 9.0 / 3.0, 1e-6);
}

/// Candidates on a surface that is curved along its rows.
struct CurvedSurface {
  int rest_columns, piece_columns;  ///< the last columns are the piece
  int rows;
  double curvature;  ///< [tolerances / column²]
  double variance;   ///< [tolerance²] of the candidates about the surface
  double step;       ///< [tolerances] of the piece from the rest

  int columns() const { return rest_columns + piece_columns; }
  double deviation(int column, int row) const {
    return curvature * column * column + (column < rest_columns ? 0.0 : step) +
           ((column + row) % 2 == 0 ? 1 : -1) * std::sqrt(variance);
  }

  MadeCandidates candidates() const {
    MadeCandidates made(columns(), rows);
    for (int column = 0; column < columns(); ++column) {
      for (int row = 0; row < rows; ++row) made.add(column, row, 1000.0 + deviation(column, row));
    }
    return made;
  }
};

/// The clusters of a curved surface.
class Pieces {
 public:
  explicit Pieces(const CurvedSurface& surface) : grid_(surface.candidates()) {
    tree_.start(grid_, {});
    const int rest_size = surface.rest_columns * surface.rows;
    rest_ = mergeAll(0, rest_size, tree_);
    piece_ = mergeAll(rest_size, tree_.leaves(), tree_);
  }

  bool isPieceOfCurved() { return tree_.isPieceOfCurved(piece_, rest_); }

  int pieceCandidates() const { return tree_.node(piece_).candidates; }
  int candidates() const { return tree_.leaves(); }

  /// Squared deviations from one plane.
  double aboutPlane() const { return tree_.varianceOfBoth(piece_, rest_) * (candidates() - 3); }

  /// Squared deviations from one quadric surface.
  double aboutQuadric() {
    FittedPixels both;
    EXPECT_TRUE(tree_.combine(piece_, rest_, both));
    return tree_.quadricVariance(tree_.merge(piece_, rest_, both)) * (candidates() - 6);
  }

  /// Squared deviations of the piece from a plane, and of the rest from a quadric surface.
  double apart() {
    return tree_.variance(piece_) * (pieceCandidates() - 3) +
           tree_.quadricVariance(rest_) * (candidates() - pieceCandidates() - 6);
  }

 private:
  MadeCandidates grid_;
  MergeTree tree_;
  int rest_ = -1, piece_ = -1;
};

/// Whether two columns are a piece of a surface at such a step that a common quadric surface adds `bounds`
/// times the mean variance, plus its floor of 0.05, for each candidate of the piece.
bool isPieceWithStep(double bounds, double curvature, double variance) {
  CurvedSurface surface{8, 2, 4, curvature, variance, 0.0};
  Pieces smooth(surface);
  surface.step = 1.0;
  const double per_square = Pieces(surface).aboutQuadric() - smooth.aboutQuadric();
  const double each = smooth.apart() / smooth.candidates() + 0.05;
  const double added = bounds * each * smooth.pieceCandidates() + smooth.apart() - smooth.aboutQuadric();
  surface.step = std::sqrt(added / per_square);
  Pieces pieces(surface);
  EXPECT_LT(pieces.aboutQuadric(), 0.1 * pieces.aboutPlane());
  return pieces.isPieceOfCurved();
}

TEST(PieceOfCurved, AddsTheMeanVarianceForEachOfItsCandidates) {
  EXPECT_TRUE(isPieceWithStep(0.75, 2.0, 2.0));
  EXPECT_FALSE(isPieceWithStep(1.5, 2.0, 2.0));
}

TEST(PieceOfCurved, AddsTheFloorOfTheVarianceForEachOfItsCandidates) {
  EXPECT_TRUE(isPieceWithStep(0.75, 1.0, 0.0));
  EXPECT_FALSE(isPieceWithStep(1.5, 1.0, 0.0));
}

/// Whether two columns are a piece of a surface of which a quadric surface leaves this fraction of the
/// squared deviations from a plane.
bool isPieceWithResidual(double fraction) {
  const double variance = 2.0, of_bend = Pieces({8, 2, 4, 1.0, 0.0, 0.0}).aboutPlane();
  const double of_noise = Pieces({8, 2, 4, 0.0, variance, 0.0}).aboutPlane();
  const double curvature = std::sqrt((1.0 / fraction - 1.0) * of_noise / of_bend);
  return Pieces({8, 2, 4, curvature, variance, 0.0}).isPieceOfCurved();
}

TEST(PieceOfCurved, LeavesAQuarterOfTheVarianceAboutAPlane) {
  EXPECT_TRUE(isPieceWithResidual(0.18));
  EXPECT_FALSE(isPieceWithResidual(0.35));
}

TEST(PieceOfCurved, BelongsToARestOfEightCandidatesAndAsLargeAsItself) {
  EXPECT_TRUE(Pieces({4, 2, 2, 2.0, 0.0, 0.0}).isPieceOfCurved());
  EXPECT_FALSE(Pieces({3, 2, 2, 2.0, 0.0, 0.0}).isPieceOfCurved()) << "six candidates";
  EXPECT_TRUE(Pieces({4, 4, 4, 2.0, 0.001, 0.0}).isPieceOfCurved());
  EXPECT_FALSE(Pieces({4, 5, 4, 2.0, 0.001, 0.0}).isPieceOfCurved()) << "the larger one";
}

constexpr int kColumns = 5;  // of the first of two pieces

/// The number of planes, and of clusters, that are found in linked candidates.
std::pair<int, int> countPlanesAndClusters(const MadeCandidates& made, double merge_cost, double max_bend) {
  Parameters parameters = adaptiveParameters(320);
  parameters.clusters.merge_cost = merge_cost;
  parameters.clusters.coplanar_cost = 0.0;
  parameters.clusters.max_curvedness = parameters.clusters.max_waviness = 1000.0;
  parameters.clusters.max_bend = max_bend;
  std::vector<PlaneCluster> clusters;
  std::vector<int> cluster_at;
  PlaneClusterer().cluster(blankDepth(0, 0), {}, made, parameters, 0.0, clusters, cluster_at);
  const auto planes = std::count_if(clusters.begin(), clusters.end(),
                                    [](const PlaneCluster& cluster) { return cluster.is_plane; });
  return {static_cast<int>(planes), static_cast<int>(clusters.size())};
}

/// The same of two pieces, of which the first one has kColumns.
/// @param links  between the pieces
std::pair<int, int> countPlanesAndClusters(MadeCandidates made, int links, double merge_cost,
                                           double max_bend) {
  made.linkColumns(0, kColumns);
  made.linkColumns(kColumns, made.columns);
  for (int row = 0; row < links; ++row) made.link(kColumns - 1, row, kColumns, row);
  return countPlanesAndClusters(made, merge_cost, max_bend);
}

/// The number of planes found in two equal pieces that are not merged.
/// @param max_bend  [tolerance²] each piece has 3, both together have more than 40
int countPlanes(int rows, int links, double max_bend) {
  constexpr double kMergeCost = 10.0;  // enough within a piece, not for both
  const CurvedSurface surface{kColumns, kColumns, rows, 1.0, 0.0, 0.0};
  const auto [planes, clusters] = countPlanesAndClusters(surface.candidates(), links, kMergeCost, max_bend);
  EXPECT_EQ(clusters, 2);
  return planes;
}

TEST(DroppedPieces, HaveThreeLinks) {
  EXPECT_EQ(countPlanes(6, 2, 5.0), 2);
  EXPECT_EQ(countPlanes(6, 3, 5.0), 0);
}

TEST(DroppedPieces, MayHaveFewerThan16Candidates) { EXPECT_EQ(countPlanes(3, 3, 5.0), 0); }

TEST(DroppedPieces, LeaveOnePlaneIfBothAreBentLittle) { EXPECT_EQ(countPlanes(6, 3, 100.0), 1); }

/// The number of planes in a flat strip beside a curved surface that is none, from which a step separates it.
int countStrips(int columns, int links) {
  constexpr double kMergeCost = 100.0, kMaxBend = 1.0;
  constexpr int kRows = 6;
  MadeCandidates made(kColumns + columns, kRows);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < made.columns; ++column)
      made.add(column, row, 1000.0 + (column < kColumns ? column * column : 100.0));
  }
  const auto [planes, clusters] = countPlanesAndClusters(made, links, kMergeCost, kMaxBend);
  EXPECT_EQ(clusters, 2);
  return planes;
}

TEST(Strip, BesideACurvedSurfaceIsPartOfItIfNarrowerThanTwoCandidates) {
  EXPECT_EQ(countStrips(1, 3), 0);
  EXPECT_EQ(countStrips(1, 2), 1) << "two links are chance";
  EXPECT_EQ(countStrips(2, 3), 1);
}

/// The number of planes in a curved surface, a flat column beside it, and a shorter one beside that.
/// @param first_row  of the shorter column: if it ends before the other one does, its cluster comes first
int countPlanesInColumns(int first_row) {
  constexpr double kMergeCost = 100.0, kMaxBend = 1.0;
  constexpr int kRows = 8, kShort = 6, kLast = kColumns + 1;
  MadeCandidates made(kLast + 1, kRows);
  const auto is_there = [first_row](int column, int row) {
    return column < kLast || (row >= first_row && row < first_row + kShort);
  };
  // The columns are tilted against each other: parallel ones would be in one plane. One of them is bent by
  // less than kMaxBend, so that they are not in one quadric surface either.
  const auto surface = [](int column, int row) {
    if (column < kColumns) return 1.0 * column * column;
    return column == kColumns ? 100.0 + 0.17 * row * row : 200.0 + 40.0 * row;
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column <= kLast; ++column) {
      if (is_there(column, row)) made.add(column, row, 1000.0 + surface(column, row));
    }
  }
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column <= kLast; ++column) {
      if (column < kLast && is_there(column + 1, row)) made.link(column, row, column + 1, row);
      if (row + 1 < kRows && is_there(column, row) && is_there(column, row + 1))
        made.link(column, row, column, row + 1);
    }
  }
  const auto [planes, clusters] = countPlanesAndClusters(made, kMergeCost, kMaxBend);
  EXPECT_EQ(clusters, 3);
  return planes;
}

TEST(Strip, ThatGoesDropsNoneBesideIt) {
  EXPECT_EQ(countPlanesInColumns(0), 1);
  EXPECT_EQ(countPlanesInColumns(2), 1);
}

// The surface leaves a variance of 5, a plane in each piece 8.
TEST(CurvedCluster, IsNotSplitIntoPlanesThatExplainItLess) {
  constexpr double kMergeCost = 1000.0;  // enough for both pieces
  const CurvedSurface surface{kColumns, kColumns, 6, 1.0, 5.0, 0.0};
  EXPECT_EQ(countPlanesAndClusters(surface.candidates(), 6, kMergeCost, 5.0), std::pair(0, 1));
}

}  // namespace
}  // namespace line_plane_segmentation
