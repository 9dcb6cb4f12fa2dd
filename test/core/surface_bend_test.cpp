// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/surface_bend.h"

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

SurfaceBend bendOf(const std::vector<Point>& points) {
  SurfaceBend bend;
  for (const Point& p : points) bend.add(p.u, p.v, p.deviation);
  return bend;
}

TEST(SurfaceBend, IsLeastSquares) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    std::vector<Point> points(static_cast<std::size_t>(random.integer(8, 60)));
    const double curvature = random.uniform(-1.0, 1.0);
    for (Point& p : points) {
      p = {random.uniform(0.0, 6.4), random.uniform(0.0, 4.8), 0.0};
      p.deviation = curvature * p.u * p.u + 0.3 * p.v + random.uniform(-0.5, 0.5);
    }
    const SurfaceBend bend = bendOf(points);
    const double count = static_cast<double>(points.size());
    EXPECT_EQ(bend.points(), static_cast<int>(points.size()));
    EXPECT_NEAR(bend.fit().plane, restOf(points, 3) / (count - 3.0), 1e-8);
    EXPECT_NEAR(bend.fit().quadric, restOf(points, 6) / (count - 6.0), 1e-6);
  }
}

TEST(SurfaceBend, LeavesNothingOfAnExactQuadric) {
  std::vector<Point> points;
  for (int u = 0; u < 4; ++u) {
    for (int v = 0; v < 3; ++v) points.push_back({0.1 * u, 0.1 * v, 2.0 * u * u - v * v + 3.0 * u});
  }
  EXPECT_GT(bendOf(points).fit().plane, 0.5);
  EXPECT_NEAR(bendOf(points).fit().quadric, 0.0, 1e-8);
}

// Points in a row fix no quadratic surface; what is asked of them is an answer all the same.
TEST(SurfaceBend, AnswersForPointsInARow) {
  std::vector<Point> points;
  for (int u = 0; u < 12; ++u) points.push_back({0.1 * u, 1.0, u % 2 == 0 ? 0.1 : -0.1});
  const SurfaceBend::Residuals rest = bendOf(points).fit();
  EXPECT_TRUE(std::isfinite(rest.plane));
  EXPECT_TRUE(std::isfinite(rest.quadric));
  EXPECT_GT(rest.quadric, 0.005);
}

TEST(SurfaceBend, StartsEmpty) { EXPECT_EQ(SurfaceBend().points(), 0); }

}  // namespace
}  // namespace line_plane_segmentation
