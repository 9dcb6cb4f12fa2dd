// SPDX-License-Identifier: BSD-3-Clause
// When two clusters of candidates are two planes; the rest of merge_tree.h is tested in merge_tree_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "planes/merge_tree.h"
#include "planes/quadric_fit.h"

namespace line_plane_segmentation {
namespace {

/// Two clusters of candidates whose planes differ by a step, too far apart to have a contact.
struct Halves {
  static constexpr int kGap = 5;  // columns between them

  int columns, rows;  ///< of each half
  double step;        ///< [tolerances]
  double variance;    ///< [tolerance²] of the candidates about their half's plane

  int size() const { return columns * rows; }
  int columnInGrid(int column) const { return column < columns ? column : column + kGap; }
  double x(int column) const { return 0.02 * columnInGrid(column); }
  static double y(int row) { return 0.02 * row; }
  double deviation(int column, int row) const {
    return (column < columns ? 0.0 : step) + ((column + row) % 2 == 0 ? 1 : -1) * std::sqrt(variance);
  }

  /// The candidate at a crossing, with ten pixels; its tolerance is 1.
  CrossingCandidate candidate(int column, int row) const {
    const double u = x(column), v = y(row), rho = 1000.0 + deviation(column, row), n = 10.0;
    CrossingCandidate at;
    at.moments = {n * u * u,   n * u * v,   n * v * v, n * u,         n * v, n,
                  n * u * rho, n * v * rho, n * rho,   n * rho * rho, n};
    at.x = u;
    at.y = v;
    at.rho = rho;
    at.inv_tolerance = 1.0;
    return at;
  }

  bool areTwoPlanes() const {
    CandidateGrid grid;
    grid.columns = 2 * columns + kGap;
    grid.rows = rows;
    grid.candidate_at.assign(static_cast<std::size_t>(grid.crossings()), -1);
    for (int column = 0; column < 2 * columns; ++column) {
      for (int row = 0; row < rows; ++row) {
        grid.candidates.push_back(candidate(column, row));
        const int cell = grid.candidates.back().cell = grid.indexOf(columnInGrid(column), row);
        grid.candidate_at[static_cast<std::size_t>(cell)] = static_cast<int>(grid.candidates.size()) - 1;
      }
    }
    MergeTree tree;
    tree.start(grid, {});
    int halves[2] = {0, size()};
    FittedPixels both;
    for (int& half : halves) {
      for (int i = half + 1, last = half + size(); i < last; ++i) {
        tree.combine(half, i, both);
        half = tree.merge(half, i, both);
      }
    }
    EXPECT_TRUE(tree.combine(halves[0], halves[1], both));
    return tree.isTwoPlanes(halves[0], halves[1], both);
  }

  /// The sum of squares that a common quadric surface leaves.
  double squaresAboutQuadric() const {
    QuadricFit quadric;
    for (int column = 0; column < 2 * columns; ++column) {
      for (int row = 0; row < rows; ++row) quadric.add(x(column), y(row), deviation(column, row));
    }
    return quadric.variance() * (quadric.points() - 6);
  }
};

/// Whether halves are two planes. Their step adds `bounds` times twice the variance plus its floor of 0.05.
bool areTwoPlanes(double bounds, double variance, int columns = 8) {
  Halves halves{columns, 4, 1.0, 0.0};
  const double per_step = halves.squaresAboutQuadric();
  const double of_halves = 2.0 * halves.size() * variance;
  const double each = of_halves / (2 * halves.size() - 6) + 0.05;
  halves.step = std::sqrt(bounds * 2.0 * each * halves.size() / per_step);
  halves.variance = variance;
  return halves.areTwoPlanes();
}

TEST(TwoPlanes, AddTwiceTheVarianceOfTheirCandidates) {
  EXPECT_FALSE(areTwoPlanes(0.8, 2.0));
  EXPECT_TRUE(areTwoPlanes(1.25, 2.0));
}

TEST(TwoPlanes, TakeThreeDegreesOfFreedomEach) {
  EXPECT_FALSE(areTwoPlanes(0.8, 2.0, 2));
  EXPECT_TRUE(areTwoPlanes(1.25, 2.0, 2));
}

TEST(TwoPlanes, AddTwiceTheFloorOfTheVariance) {
  EXPECT_FALSE(areTwoPlanes(0.8, 0.0));
  EXPECT_TRUE(areTwoPlanes(1.25, 0.0));
}

TEST(TwoPlanes, HaveEightCandidatesEach) {
  EXPECT_TRUE((Halves{2, 4, 20.0, 0.0}.areTwoPlanes()));
  EXPECT_FALSE((Halves{2, 3, 20.0, 0.0}.areTwoPlanes()));
}

}  // namespace
}  // namespace line_plane_segmentation
