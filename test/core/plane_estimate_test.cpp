// SPDX-License-Identifier: BSD-3-Clause
#include "refine/plane_estimate.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr double kNoise = 0.002;  // [1/m] of the inverse depth

/// A cluster of the pixels of a grid of rays that see the surface, in units of the noise.
PlaneCluster seen(const Surface& surface, double noise, Random& random) {
  PlaneCluster cluster;
  for (double x = -0.3; x < 0.31; x += 0.05) {
    for (double y = -0.2; y < 0.21; y += 0.05) {
      const double w = 1.0 / surface.depthAlong(x, y) + noise * random.gaussian();
      RegressionMoments one;
      one.xx = x * x;
      one.xy = x * y;
      one.yy = y * y;
      one.x = x;
      one.y = y;
      one.weight = one.pixels = 1.0;
      one.x_rho = x * w;
      one.y_rho = y * w;
      one.rho = w;
      one.rho_rho = w * w;
      one.scale(1.0 / (kNoise * kNoise));
      cluster.moments += one;
      // Each pixel is a candidate here.
      cluster.means += one;
      ++cluster.candidates;
    }
  }
  EXPECT_TRUE(cluster.moments.fit(cluster.plane, cluster.squared_error));
  return cluster;
}

TEST(EstimatePlane, IsTheClustersPlane) {
  Random random(1);
  for (const Surface& surface : {surfaceAt(1.0), surfaceAt(2.5, 0.7, -0.4), surfaceAt(0.6, -1.0, 0.2)}) {
    const PlaneEstimate estimate = estimatePlane(seen(surface, 0.0, random));
    EXPECT_LT((estimate.normal - surface.normal).norm(), 1e-9);
    EXPECT_NEAR(estimate.d, surface.d, 1e-9);
    EXPECT_NEAR(estimate.normal.norm(), 1.0, 1e-12);
    EXPECT_LT(estimate.covariance.norm(), 1e-12) << "without noise it is sure";
  }
}

TEST(EstimatePlane, HasACovarianceOfTheShapeThatRepeatedNoiseGives) {
  Random random(2);
  const Surface surface = surfaceAt(1.8, 0.6, -0.3);
  constexpr int kTrials = 4000;
  Eigen::Matrix4d sampled = Eigen::Matrix4d::Zero(), predicted = Eigen::Matrix4d::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    const PlaneEstimate estimate = estimatePlane(seen(surface, kNoise, random));
    Eigen::Vector4d difference;
    difference << estimate.normal - surface.normal, estimate.d - surface.d;
    sampled += difference * difference.transpose() / kTrials;
    predicted += estimate.covariance / kTrials;
  }
  // Here pixels share no errors. The factor for those that do is the same in each direction in which a plane
  // can move.
  const double factor = predicted(3, 3) / sampled(3, 3);
  EXPECT_NEAR(factor, 2.9, 0.2) << "2.6 candidates count as one; the prior adds a tenth";
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(predicted);
  for (int i = 1; i < 4; ++i) {
    const Eigen::Vector4d axis = solver.eigenvectors().col(i);
    EXPECT_NEAR(axis.dot(sampled * axis) * factor / solver.eigenvalues()[i], 1.0, 0.12) << i;
  }
}

TEST(EstimatePlane, HasACovarianceThatIsSingularAlongTheNormalOnly) {
  Random random(3);
  const PlaneEstimate estimate = estimatePlane(seen(surfaceAt(1.8, 0.6, -0.3), kNoise, random));
  Eigen::Vector4d along_normal = Eigen::Vector4d::Zero();
  along_normal.head<3>() = estimate.normal;
  EXPECT_LT((estimate.covariance * along_normal).norm(), 1e-9 * estimate.covariance.norm());
  EXPECT_LT((estimate.covariance - estimate.covariance.transpose()).norm(),
            1e-9 * estimate.covariance.norm());
  const Eigen::Vector4d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(estimate.covariance).eigenvalues();
  EXPECT_GT(eigenvalues[1], 1e-6 * eigenvalues[3]);
}

/// The variance of d of a plane 2 m ahead, in squared tolerances of a pixel, from candidates that lie in it.
/// The pixels deviate by one tolerance.
double varianceOfDistance(int candidates) {
  constexpr double kPixels = 1000.0;
  PlaneCluster cluster;
  for (int i = 0; i < candidates; ++i) {
    const double angle = 2.0 * M_PI * i / candidates, x = std::cos(angle), y = std::sin(angle);
    cluster.means += {x * x, x * y, y * y, x, y, 1.0, 0.5 * x, 0.5 * y, 0.5, 0.25, 1.0};
  }
  cluster.plane = {0.0, 0.0, 0.5};
  cluster.candidates = candidates;
  cluster.moments.pixels = kPixels;
  cluster.squared_error = kPixels - 3.0;
  // An error of 1 / d is one of d times d². All pixels have the same weight.
  return estimatePlane(cluster).covariance(3, 3) / std::pow(2.0, 4) * kPixels;
}

TEST(EstimatePlane, TakesTheVarianceOfFewCandidatesFromTheirPixels) {
  EXPECT_NEAR(varianceOfDistance(3), 12.0, 0.01) << "twelve pixels count as one";
  EXPECT_NEAR(varianceOfDistance(7), 6.0, 0.01) << "four degrees of freedom weigh as much as the pixels";
}

TEST(EstimateFromPixels, FitsANarrowStripAlongTheRaysAndTrustsFewPixels) {
  Random random(4);
  const Surface surface = surfaceAt(1.5, 0.4);
  constexpr int kTrials = 300, kPixels = 800;
  double error = 0.0, error_of_axes = 0.0, predicted = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    PointMoments moments;
    for (int i = 0; i < kPixels; ++i) {
      // As narrow as the noise is large: 3 cm.
      const double x = random.uniform(-0.2, 0.2), y = random.uniform(-0.01, 0.01);
      const double z = surface.depthAlong(x, y) + 0.01 * random.gaussian();
      moments.add({x * z, y * z, z});
    }
    PlaneFit fit;
    ASSERT_TRUE(fitPlane(moments, fit));
    const PlaneEstimate estimate = estimateFromPixels(fit, moments);
    error += (estimate.normal - surface.normal).squaredNorm() / kTrials;
    error_of_axes += (fit.normal - surface.normal).squaredNorm() / kTrials;
    predicted += estimate.covariance.topLeftCorner<3, 3>().trace() / kTrials;
    EXPECT_NEAR(estimate.d, surface.d, 0.05);
  }
  EXPECT_LT(error, 0.5 * error_of_axes) << "the principal axes follow the noise";
  EXPECT_NEAR(predicted / error / (kPixels / 48.0), 1.0, 0.25) << "pixels count as 48 independent ones";
}

/// The variance of d of a plane of four pixels that do not lie in it, or of so many times as many.
double varianceOfFourPixels(int times) {
  PointMoments moments;
  for (int i = 0; i < 4 * times; ++i) {
    const double x = i % 2 == 0 ? -0.1 : 0.1, y = i / 2 % 2 == 0 ? -0.1 : 0.1, z = 2.0 + x * y;
    moments.add({x * z, y * z, z});
  }
  PlaneFit fit;
  EXPECT_TRUE(fitPlane(moments, fit));
  return estimateFromPixels(fit, moments).covariance(3, 3);
}

TEST(EstimateFromPixels, TakesThreeDegreesOfFreedom) {
  EXPECT_NEAR(varianceOfFourPixels(1) / varianceOfFourPixels(2), 8.0 - 3.0, 1e-6);
  EXPECT_NEAR(varianceOfFourPixels(1) / varianceOfFourPixels(24), (96.0 - 3.0) / 2.0, 1e-6)
      << "a pixel of 96 counts as a half, one of fewer than 48 as one";
}

TEST(EstimateFromPixels, TakesTheFitOfPixelsOnOneRay) {
  PlaneFit fit;
  fit.d = 2.0;
  PointMoments moments;
  for (int i = 0; i < 5; ++i) moments.add({0.0, 0.0, 0.0});
  const PlaneEstimate estimate = estimateFromPixels(fit, moments);
  EXPECT_EQ(estimate.normal, fit.normal);
  EXPECT_EQ(estimate.d, fit.d);
}

}  // namespace
}  // namespace line_plane_segmentation
