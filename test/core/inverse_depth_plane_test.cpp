// SPDX-License-Identifier: BSD-3-Clause
#include "planes/inverse_depth_plane.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <vector>

#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

InverseDepthPlane planeOf(const Surface& surface) {
  return {-surface.normal.x() / surface.d, -surface.normal.y() / surface.d, -surface.normal.z() / surface.d};
}

TEST(InverseDepthPlane, IsThePlaneAlongEveryRay) {
  for (const Surface& surface : {surfaceAt(1.0), surfaceAt(2.5, 0.8, -0.4), surfaceAt(0.7, -1.1, 0.3)}) {
    const InverseDepthPlane plane = planeOf(surface);
    EXPECT_NEAR(plane.inverseDistance(), 1.0 / surface.d, 1e-12);
    for (const double x : {-0.5, 0.0, 0.3}) {
      for (const double y : {-0.4, 0.2}) EXPECT_NEAR(plane.at(x, y), 1.0 / surface.depthAlong(x, y), 1e-12);
    }
  }
}

TEST(DepthTolerance, AlongTheRayIsTheNoiseInInverseDepth) {
  const NoiseParameters noise;
  const DepthTolerance tolerance{noise, 3.0, 0.0};
  for (const double z : {0.4, 1.0, 2.5, 8.0}) {
    // dw = dz / z².
    EXPECT_NEAR(tolerance.along(1.0 / z), 3.0 * noise.sigma(z) / (z * z), 1e-15) << z;
    EXPECT_EQ(tolerance.at(1.0 / z, 0.5), tolerance.along(1.0 / z)) << z;
  }
}

TEST(DepthTolerance, AcrossThePlaneIsADistance) {
  const Surface surface = surfaceAt(1.4, 0.7, 0.2);
  const double distance = 0.03;
  const DepthTolerance tolerance{{}, 0.0, distance};
  for (const double x : {-0.4, 0.0, 0.4}) {
    // The point of this ray that lies so far before the plane.
    const Eigen::Vector3d ray(x, 0.1, 1.0);
    const double z = (distance - surface.d) / surface.normal.dot(ray);
    ASSERT_NEAR(surface.normal.dot(z * ray) + surface.d, distance, 1e-12);
    EXPECT_NEAR(std::abs(1.0 / z - 1.0 / surface.depthAlong(x, 0.1)), tolerance.at(1.0 / z, 1.0 / surface.d),
                1e-12);
  }
}

/// Weighted samples of inverse depth, and their sums.
struct Samples {
  std::vector<double> x, y, w, weight;

  Samples(int count, const InverseDepthPlane& plane, double noise, Random& random) {
    for (int i = 0; i < count; ++i) {
      x.push_back(random.uniform(-0.5, 0.5));
      y.push_back(random.uniform(-0.4, 0.4));
      w.push_back(plane.at(x.back(), y.back()) + noise * random.gaussian());
      weight.push_back(random.uniform(0.5, 3.0));
    }
  }

  RegressionMoments moments(std::size_t first, std::size_t last) const {
    RegressionMoments m;
    for (std::size_t i = first; i < last; ++i) {
      RegressionMoments one;
      one.xx = x[i] * x[i];
      one.xy = x[i] * y[i];
      one.yy = y[i] * y[i];
      one.x = x[i];
      one.y = y[i];
      one.weight = one.pixels = 1.0;
      one.x_rho = x[i] * w[i];
      one.y_rho = y[i] * w[i];
      one.rho = w[i];
      one.rho_rho = w[i] * w[i];
      one.scale(weight[i]);
      m += one;
    }
    return m;
  }
  RegressionMoments moments() const { return moments(0, x.size()); }

  double squaredErrorTo(const InverseDepthPlane& plane) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += weight[i] * std::pow(w[i] - plane.at(x[i], y[i]), 2);
    return sum;
  }

  InverseDepthPlane leastSquares() const {
    Eigen::MatrixX3d matrix(static_cast<Eigen::Index>(x.size()), 3);
    Eigen::VectorXd right(static_cast<Eigen::Index>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double root = std::sqrt(weight[i]);
      matrix.row(static_cast<Eigen::Index>(i)) << root * x[i], root * y[i], root;
      right[static_cast<Eigen::Index>(i)] = root * w[i];
    }
    const Eigen::Vector3d solution = matrix.colPivHouseholderQr().solve(right);
    return {solution.x(), solution.y(), solution.z()};
  }
};

/// The plane of moments that are not degenerate.
/// @return the sum of squared errors
double fit(const RegressionMoments& moments, InverseDepthPlane& plane) {
  double squared_error = -1.0;
  EXPECT_TRUE(moments.fit(plane, squared_error));
  return squared_error;
}

bool isDegenerate(const RegressionMoments& moments) {
  InverseDepthPlane plane;
  double squared_error = 0.0;
  return !moments.fit(plane, squared_error);
}

TEST(RegressionMoments, FitIsTheWeightedLeastSquaresPlane) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const InverseDepthPlane truth{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.2, 2.0)};
    const Samples samples(random.integer(4, 60), truth, 0.01, random);
    InverseDepthPlane plane;
    const double squared_error = fit(samples.moments(), plane);
    const InverseDepthPlane expected = samples.leastSquares();
    EXPECT_NEAR(plane.a, expected.a, 1e-9);
    EXPECT_NEAR(plane.b, expected.b, 1e-9);
    EXPECT_NEAR(plane.c, expected.c, 1e-9);
    EXPECT_NEAR(squared_error, samples.squaredErrorTo(plane), 1e-9);
    EXPECT_LE(squared_error, samples.squaredErrorTo(truth));
  }
}

TEST(RegressionMoments, OfPartsAddUp) {
  Random random(2);
  const Samples samples(30, {0.1, -0.2, 0.7}, 0.01, random);
  RegressionMoments parts = samples.moments(0, 11);
  parts += samples.moments(11, 30);
  InverseDepthPlane of_parts, of_all;
  EXPECT_NEAR(fit(parts, of_parts), fit(samples.moments(), of_all), 1e-12);
  EXPECT_NEAR(of_parts.a, of_all.a, 1e-12);
  EXPECT_NEAR(of_parts.c, of_all.c, 1e-12);
  EXPECT_EQ(parts.pixels, 30.0);
}

TEST(RegressionMoments, ScaleWeighsTheErrorsNotThePlaneOrThePixels) {
  Random random(3);
  const Samples samples(30, {0.1, -0.2, 0.7}, 0.01, random);
  RegressionMoments scaled = samples.moments();
  scaled.scale(100.0);
  InverseDepthPlane before, after;
  EXPECT_NEAR(fit(scaled, after), 100.0 * fit(samples.moments(), before), 1e-9);
  EXPECT_NEAR(after.a, before.a, 1e-9);
  EXPECT_NEAR(after.b, before.b, 1e-9);
  EXPECT_NEAR(after.c, before.c, 1e-9);
  EXPECT_EQ(scaled.pixels, 30.0);
}

TEST(RegressionMoments, NeedPixelsThatFixAPlane) {
  Random random(4);
  EXPECT_TRUE(isDegenerate(RegressionMoments{}));
  for (const int count : {1, 2})
    EXPECT_TRUE(isDegenerate(Samples(count, {0.1, 0.2, 0.7}, 0.0, random).moments())) << count;
  Samples line(20, {0.1, 0.2, 0.7}, 0.01, random);
  for (std::size_t i = 0; i < line.y.size(); ++i) line.y[i] = 0.3 - 2.0 * line.x[i];
  EXPECT_TRUE(isDegenerate(line.moments()));
  Samples row(20, {0.1, 0.2, 0.7}, 0.01, random);
  for (double& y : row.y) y = 0.25;
  EXPECT_TRUE(isDegenerate(row.moments()));
}

// Four pixels on a diagonal of the image, except for a fraction of their variance.
TEST(RegressionMoments, NeedABillionthOfTheVarianceAcross) {
  const auto is_degenerate = [](double fraction) {
    const double side = 0.5 * std::sqrt(fraction);
    RegressionMoments moments;
    for (const double along : {-1.0, 1.0}) {
      for (const double across : {-side, side}) {
        const double x = along + across, y = along - across;
        moments += {x * x, x * y, y * y, x, y, 1.0, x, y, 1.0, 1.0, 1.0};
      }
    }
    return isDegenerate(moments);
  };
  EXPECT_TRUE(is_degenerate(0.7e-9));
  EXPECT_FALSE(is_degenerate(1.5e-9));
}

}  // namespace
}  // namespace line_plane_segmentation
