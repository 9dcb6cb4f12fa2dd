// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "support/principal_axes.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

PointMoments momentsOf(const std::vector<Eigen::Vector3d>& points) {
  PointMoments moments;
  for (const Eigen::Vector3d& p : points) moments.add(p);
  return moments;
}

/// Points on a patch of a surface, 0.4 m wide, moved across it by Gaussian noise [m].
std::vector<Eigen::Vector3d> noisyPatch(const Surface& surface, int count, double noise, Random& random) {
  const Eigen::Vector3d foot = -surface.d * surface.normal;
  const Eigen::Vector3d t1 = surface.normal.unitOrthogonal(), t2 = surface.normal.cross(t1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(foot + random.uniform(0.1, 0.5) * t1 + random.uniform(-0.3, 0.1) * t2 +
                     noise * random.gaussian() * surface.normal);
  }
  return points;
}

TEST(FitPlane, AgreesWithSingularValuesOfTheCentredPoints) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Surface surface{random.direction(), random.uniform(0.3, 5.0)};
    const int count = random.integer(4, 400);
    const std::vector<Eigen::Vector3d> points =
        noisyPatch(surface, count, random.uniform(1e-4, 0.02), random);
    PlaneFit plane;
    ASSERT_TRUE(fitPlane(momentsOf(points), plane));

    const PrincipalAxes axes = principalAxesOf(points);
    EXPECT_NEAR(std::abs(plane.normal.dot(axes.normal)), 1.0, 1e-9);
    EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-12);
    EXPECT_LT((plane.centroid - axes.centroid).norm(), 1e-12);
    EXPECT_NEAR(plane.mean_square, axes.variances[2], 1e-12);
    EXPECT_NEAR(plane.curvature, axes.curvature(), 1e-9);
    EXPECT_NEAR(plane.normal.dot(axes.centroid) + plane.d, 0.0, 1e-12);
    EXPECT_GE(plane.d, 0.0);
  }
}

TEST(FitPlane, TurnsTheNormalToTheCamera) {
  for (const double yaw : {-1.4, -0.5, 0.0, 0.5, 1.4}) {
    const Surface surface = surfaceAt(2.0, yaw, 0.3);
    Random random(2);
    PlaneFit plane;
    ASSERT_TRUE(fitPlane(momentsOf(noisyPatch(surface, 50, 0.0, random)), plane));
    EXPECT_LT((plane.normal - surface.normal).norm(), 1e-7) << yaw;
    EXPECT_NEAR(plane.d, surface.d, 1e-7) << yaw;
    EXPECT_LT(plane.normal.dot(plane.centroid), 0.0) << yaw;
    EXPECT_LT(plane.mean_square, 1e-12) << yaw;
  }
}

TEST(FitPlane, NeedsPointsThatSpanAPlane) {
  const Eigen::Vector3d a(0.1, 0.2, 1.0), b(0.3, 0.1, 1.5), c(-0.2, 0.4, 1.2);
  PlaneFit plane;
  EXPECT_FALSE(fitPlane(PointMoments{}, plane));
  EXPECT_FALSE(fitPlane(momentsOf({a}), plane));
  EXPECT_FALSE(fitPlane(momentsOf({a, b}), plane));
  EXPECT_TRUE(fitPlane(momentsOf({a, b, c}), plane));
  EXPECT_FALSE(fitPlane(momentsOf({a, a, a, a}), plane));
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i <= 40; ++i) line.push_back(4.0 * (a + i / 40.0 * (b - a)));
  EXPECT_FALSE(fitPlane(momentsOf(line), plane));
}

TEST(FitPlane, RefusesNumbersThatAreNone) {
  const double bad[] = {std::nan(""), std::numeric_limits<double>::infinity()};
  for (const double value : bad) {
    PlaneFit plane;
    EXPECT_FALSE(fitPlane(momentsOf({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {value, 1, 1}}), plane)) << value;
  }
}

TEST(PointMoments, OfPartsAddUp) {
  Random random(3);
  const std::vector<Eigen::Vector3d> points = noisyPatch(surfaceAt(1.0, 0.3), 60, 0.01, random);
  PointMoments parts = momentsOf({points.begin(), points.begin() + 20});
  parts += momentsOf({points.begin() + 20, points.end()});
  const PointMoments all = momentsOf(points);
  EXPECT_EQ(parts.count, 60.0);
  EXPECT_LT((parts.sum - all.sum).norm(), 1e-12);
  EXPECT_LT((parts.outer - all.outer).norm(), 1e-12);
}

TEST(PlaneCovariance, IsThatOfRepeatedNoise) {
  Random random(4);
  const double sigma = 0.004;
  for (const Surface& surface : {surfaceAt(1.0), surfaceAt(2.5, 0.8, -0.3)}) {
    const std::vector<Eigen::Vector3d> exact = noisyPatch(surface, 60, 0.0, random);
    PlaneFit truth;
    ASSERT_TRUE(fitPlane(momentsOf(exact), truth));
    const Eigen::Matrix4d predicted = truth.covariance(momentsOf(exact), sigma);

    constexpr int kTrials = 20000;
    Eigen::Matrix4d sampled = Eigen::Matrix4d::Zero();
    for (int trial = 0; trial < kTrials; ++trial) {
      PointMoments moments;
      for (const Eigen::Vector3d& p : exact) moments.add(p + sigma * random.gaussian() * truth.normal);
      PlaneFit fit;
      ASSERT_TRUE(fitPlane(moments, fit));
      Eigen::Vector4d difference;
      difference << fit.normal - truth.normal, fit.d - truth.d;
      sampled += difference * difference.transpose() / kTrials;
    }
    // Along each of the three directions in which a plane can move, the variances agree.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(predicted);
    for (int i = 1; i < 4; ++i) {
      const Eigen::Vector4d axis = solver.eigenvectors().col(i);
      EXPECT_NEAR(axis.dot(sampled * axis) / solver.eigenvalues()[i], 1.0, 0.06) << i;
    }
    EXPECT_LT((sampled - predicted).norm(), 0.06 * predicted.norm());
  }
}

TEST(PlaneCovariance, IsSymmetricAndSingularAlongTheNormalOnly) {
  Random random(5);
  const std::vector<Eigen::Vector3d> points = noisyPatch(surfaceAt(1.5, 0.4, 0.2), 100, 0.002, random);
  PlaneFit plane;
  ASSERT_TRUE(fitPlane(momentsOf(points), plane));
  const Eigen::Matrix4d covariance = plane.covariance(momentsOf(points), 0.002);
  EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-12 * covariance.norm());
  Eigen::Vector4d along_normal = Eigen::Vector4d::Zero();
  along_normal.head<3>() = plane.normal;
  EXPECT_LT((covariance * along_normal).norm(), 1e-12 * covariance.norm());
  const Eigen::Vector4d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(covariance).eigenvalues();
  EXPECT_GT(eigenvalues[1], 1e-9 * eigenvalues[3]);
}

TEST(PlaneCovariance, GoesWithTheSquareOfTheNoise) {
  Random random(6);
  const std::vector<Eigen::Vector3d> points = noisyPatch(surfaceAt(1.5), 100, 0.0, random);
  PlaneFit plane;
  ASSERT_TRUE(fitPlane(momentsOf(points), plane));
  const Eigen::Matrix4d once = plane.covariance(momentsOf(points), 0.001);
  EXPECT_LT((plane.covariance(momentsOf(points), 0.003) - 9.0 * once).norm(), 1e-12);
  EXPECT_EQ(plane.covariance(momentsOf(points), 0.0).norm(), 0.0);
}

// Four points on a line, except for a fraction of their variance.
TEST(FitPlane, NeedsABillionthOfTheVarianceAcross) {
  const auto is_fitted = [](double fraction) {
    const double side = std::sqrt(fraction);
    PlaneFit plane;
    return fitPlane(momentsOf({{1.0, side, 0.0}, {1.0, -side, 0.0}, {-1.0, side, 0.0}, {-1.0, -side, 0.0}}),
                    plane);
  };
  EXPECT_FALSE(is_fitted(0.7e-9));
  EXPECT_TRUE(is_fitted(1.5e-9));
}

}  // namespace
}  // namespace line_plane_segmentation
