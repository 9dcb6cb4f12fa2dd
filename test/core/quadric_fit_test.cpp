// SPDX-License-Identifier: BSD-3-Clause
#include "planes/quadric_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "support/random.h"

namespace line_plane_segmentation {
namespace {

struct Point {
  double u, v, deviation;
};

// The sum of squared rests of a least-squares fit by orthogonal decomposition, with the first `terms` of 1,
// u, v, u², uv, v².
double restOf(const std::vector<Point>& points, int terms) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), terms);
  Eigen::VectorXd deviations(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [u, v, deviation] = points[i];
    Eigen::RowVectorXd all(6);
    all << 1.0, u, v, u * u, u * v, v * v;
    matrix.row(static_cast<Eigen::Index>(i)) = all.head(terms);
    deviations[static_cast<Eigen::Index>(i)] = deviation;
  }
  return (matrix * matrix.colPivHouseholderQr().solve(deviations) - deviations).squaredNorm();
}

QuadricFit fitOf(const std::vector<Point>& points) {
  QuadricFit fit;
  for (const Point& p : points) fit.add(p.u, p.v, p.deviation);
  return fit;
}

TEST(QuadricFit, IsLeastSquares) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    std::vector<Point> points(static_cast<std::size_t>(random.integer(8, 60)));
    const double curvature = random.uniform(-1.0, 1.0);
    for (Point& p : points) {
      p = {random.uniform(0.0, 6.4), random.uniform(0.0, 4.8), 0.0};
      p.deviation = curvature * p.u * p.u + 0.3 * p.v + random.uniform(-0.5, 0.5);
    }
    const QuadricFit fit = fitOf(points);
    const double count = static_cast<double>(points.size());
    EXPECT_EQ(fit.points(), static_cast<int>(points.size()));
    EXPECT_NEAR(fit.variance(), restOf(points, 6) / (count - 6.0), 1e-6);
  }
}

TEST(QuadricFit, IsZeroForAnExactQuadric) {
  std::vector<Point> points;
  for (int u = 0; u < 4; ++u) {
    for (int v = 0; v < 3; ++v) points.push_back({0.1 * u, 0.1 * v, 2.0 * u * u - v * v + 3.0 * u});
  }
  EXPECT_NEAR(fitOf(points).variance(), 0.0, 1e-8);
}

// Points in a row are degenerate for a quadric surface.
TEST(QuadricFit, IsFiniteForPointsInARow) {
  std::vector<Point> points;
  for (int u = 0; u < 12; ++u) points.push_back({0.1 * u, 1.0, u % 2 == 0 ? 0.1 : -0.1});
  const double variance = fitOf(points).variance();
  EXPECT_TRUE(std::isfinite(variance));
  EXPECT_GT(variance, 0.005);
}

TEST(QuadricFit, StartsEmpty) { EXPECT_EQ(QuadricFit().points(), 0); }

}  // namespace
}  // namespace line_plane_segmentation
