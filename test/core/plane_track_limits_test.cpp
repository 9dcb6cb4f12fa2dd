// SPDX-License-Identifier: BSD-3-Clause
// Outliers, restarts and the least errors of a measurement; the rest of plane_track_filter.h is tested in
// plane_track_filter_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "line_plane_segmentation/plane_track_filter.h"

namespace line_plane_segmentation {
namespace {

constexpr double kAngle = 0.01;      // [rad] standard deviations of a measurement
constexpr double kDistance = 0.005;  // [m]

/// A wall two metres ahead, turned by `angle` [rad] about the vertical axis and moved by `offset` [m].
SegmentedPlane wall(double angle, double offset) {
  SegmentedPlane plane;
  plane.normal = {std::sin(angle), 0.0, -std::cos(angle)};
  plane.centroid = {0.0, 0.0, 2.0};
  plane.d = offset - plane.normal.dot(plane.centroid);
  Eigen::Matrix<double, 4, 3> jacobian = Eigen::Matrix<double, 4, 3>::Zero();  // by two rotations and d
  jacobian(0, 0) = jacobian(1, 1) = jacobian(3, 2) = 1.0;
  const Eigen::Vector3d variances(kAngle * kAngle, kAngle * kAngle, kDistance * kDistance);
  plane.covariance = jacobian * variances.asDiagonal() * jacobian.transpose();
  return plane;
}

/// A camera at rest whose pose is exact.
struct Filter : PlaneTrackFilter {
  static FusionParameters exactPose() {
    FusionParameters parameters;
    parameters.fusion_pose_angle = parameters.fusion_pose_distance = 0.0;
    return parameters;
  }

  explicit Filter(const SegmentedPlane& measured)
      : PlaneTrackFilter(measured, Eigen::Isometry3d::Identity(), exactPose()) {}
  double add(const SegmentedPlane& measured) {
    return update(measured, Eigen::Isometry3d::Identity(), exactPose());
  }
};

bool isOutlier(double squared_distance) {
  Filter filter(wall(0.0, 0.0));
  const double offset = kDistance * std::sqrt(2.0 * squared_distance);
  EXPECT_NEAR(filter.add(wall(0.0, offset)), squared_distance, 0.1);
  return filter.observations() == 1;
}

// 11.3 is the 99 % quantile of chi-squared with three degrees of freedom.
TEST(Outliers, LieBeyondTheQuantileOfChiSquared) {
  EXPECT_FALSE(isOutlier(9.0));
  EXPECT_TRUE(isOutlier(15.0));
}

int outliersUntilRestart(int inliers) {
  Filter filter(wall(0.0, 0.0));
  for (int i = 1; i < inliers; ++i) filter.add(wall(0.0, 0.0));
  int outliers = 0;
  while (filter.observations() > 1 && outliers < 200) {
    filter.add(wall(0.5, 0.5));
    ++outliers;
  }
  return outliers;
}

TEST(Outliers, RestartTheFilterAfter30InARowOrTwoPerInlier) {
  EXPECT_EQ(outliersUntilRestart(50), 31);
  EXPECT_EQ(outliersUntilRestart(20), 31);
  EXPECT_EQ(outliersUntilRestart(13), 27);
  EXPECT_EQ(outliersUntilRestart(3), 7);
}

// A plane without a covariance has standard deviations of 1e-4 rad and 1e-4 m.
TEST(LeastErrors, WeighAMeasurementWithoutCovariance) {
  SegmentedPlane exact = wall(0.0, 0.0), other = wall(2e-4, 2e-4);
  exact.covariance.setZero();
  for (const int i : {0, 1}) other.covariance(i, i) = 3e-8;
  other.covariance(3, 3) = 3e-8;
  Filter filter(exact);
  filter.add(other);
  // Variances of 1e-8 and 4e-8: the second measurement has a fifth of the weight.
  EXPECT_NEAR(std::asin(filter.normal().x()), 4e-5, 4e-6);
  EXPECT_NEAR(filter.d() - exact.d, 4e-5, 4e-6);
}

}  // namespace
}  // namespace line_plane_segmentation
