// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_track_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/random.h"

namespace line_plane_segmentation {
namespace {

constexpr double kAngle = 0.01;      // [rad] standard deviations of the measurements
constexpr double kDistance = 0.005;  // [m] at the centroid

double angleOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// A wall two metres ahead of a camera that stands far from the fixed frame's origin.
class Fusion : public testing::Test {
 protected:
  Fusion() {
    pose_.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    pose_.translation() << 800.0, -300.0, 1.2;
    parameters_.fusion_pose_angle = parameters_.fusion_pose_distance = 0.0;
  }

  // The plane with a normal that is rotated about two axes, and moved along it at the centroid.
  SegmentedPlane measured(double a, double b, double offset) const {
    const Eigen::Vector3d x = normal_.unitOrthogonal(), y = normal_.cross(x);
    SegmentedPlane plane;
    plane.normal = (normal_ + a * x + b * y).normalized();
    plane.centroid = centroid_;
    plane.d = offset - plane.normal.dot(centroid_);
    Eigen::Matrix<double, 4, 3> jacobian;
    jacobian << x, y, Eigen::Vector3d::Zero(), -centroid_.dot(x), -centroid_.dot(y), 1.0;
    const Eigen::Vector3d variances(kAngle * kAngle, kAngle * kAngle, kDistance * kDistance);
    plane.covariance = jacobian * variances.asDiagonal() * jacobian.transpose();
    return plane;
  }

  SegmentedPlane noisy(Random& random) const {
    return measured(kAngle * random.gaussian(), kAngle * random.gaussian(), kDistance * random.gaussian());
  }

  Eigen::Vector3d trueNormal() const { return pose_.linear() * normal_; }
  double errorAtCentroid(const PlaneTrackFilter& filter) const {
    return filter.normal().dot(pose_ * centroid_) + filter.d();
  }

  /// Expects the covariance of a filter to be that of measurements with many drawn errors of the pose.
  /// @param draw  sets a rotation vector about the camera [rad] and a translation [m]
  template <typename Draw>
  void expectCovarianceOfPoses(const CameraVelocity& velocity, Draw&& draw) const {
    const SegmentedPlane exact = measured(0.0, 0.0, 0.0);
    const PlaneTrackFilter filter(exact, pose_, parameters_, velocity);
    const Eigen::Vector3d point = pose_ * centroid_;
    double of_normal = 0.0, of_offset = 0.0;
    constexpr int kRuns = 2000;
    for (int run = 0; run < kRuns; ++run) {
      Eigen::Vector3d turn, shift;
      draw(turn, shift);
      const Eigen::Matrix3d wrong = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose_.linear();
      const Eigen::Vector3d normal = wrong * exact.normal;
      of_normal += std::pow(angleOf(trueNormal(), normal), 2) / kRuns;
      of_offset += std::pow(normal.dot(point - pose_.translation() - shift) + exact.d, 2) / kRuns;
    }
    const Eigen::Matrix4d covariance = filter.covariance();
    Eigen::Vector4d at_point;
    at_point << point, 1.0;
    const Eigen::Matrix3d covariance_of_normal = covariance.topLeftCorner<3, 3>();
    EXPECT_NEAR(of_normal + 2.0 * kAngle * kAngle, covariance_of_normal.trace(), 0.1 * of_normal);
    EXPECT_NEAR(of_offset + kDistance * kDistance, at_point.dot(covariance * at_point), 0.1 * of_offset);
  }

  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d normal_ = Eigen::Vector3d(0.3, -0.2, -1.0).normalized();
  Eigen::Vector3d centroid_{0.4, 0.1, 2.0};
  FusionParameters parameters_;  // with an exact pose
};

TEST_F(Fusion, startsAtTheMeasurement) {
  const SegmentedPlane plane = measured(0.02, -0.01, 0.003);
  const PlaneTrackFilter filter(plane, pose_, parameters_);
  EXPECT_NEAR(0.0, angleOf(pose_.linear() * plane.normal, filter.normal()), 1e-12);
  EXPECT_NEAR(0.003, errorAtCentroid(filter), 1e-9);
  EXPECT_EQ(1U, filter.observations());
}

TEST_F(Fusion, averagesEquallyCertainMeasurements) {
  PlaneTrackFilter filter(measured(0.01, 0.0, 0.004), pose_, parameters_);
  filter.update(measured(-0.01, 0.0, -0.002), pose_, parameters_);
  EXPECT_NEAR(0.0, angleOf(trueNormal(), filter.normal()), 1e-5);
  EXPECT_NEAR(0.001, errorAtCentroid(filter), 1e-6);
  EXPECT_EQ(2U, filter.observations());
}

TEST_F(Fusion, weighsByCovariance) {
  PlaneTrackFilter filter(measured(0.0, 0.0, 0.0), pose_, parameters_);
  SegmentedPlane certain = measured(0.009, 0.0, 0.006);
  certain.covariance /= 4.0;
  filter.update(certain, pose_, parameters_);
  EXPECT_NEAR(0.009 * 0.8, angleOf(trueNormal(), filter.normal()), 1e-4);
  EXPECT_NEAR(0.006 * 0.8, errorAtCentroid(filter), 1e-4);
}

TEST_F(Fusion, isConsistentWithItsCovariance) {
  Random random(5);
  double nees = 0.0, single = 0.0, fused = 0.0;
  constexpr int kRuns = 300;
  for (int run = 0; run < kRuns; ++run) {
    PlaneTrackFilter filter(noisy(random), pose_, parameters_);
    for (int i = 1; i < 10; ++i) filter.update(noisy(random), pose_, parameters_);
    // At the true plane, in rotations and offset at the centroid.
    const Eigen::Vector3d x = trueNormal().unitOrthogonal(), y = trueNormal().cross(x);
    const Eigen::Vector3d point = pose_ * centroid_;
    Eigen::Matrix<double, 3, 4> jacobian = Eigen::Matrix<double, 3, 4>::Zero();
    jacobian.row(0).head<3>() = x;
    jacobian.row(1).head<3>() = y;
    jacobian.row(2) << point.transpose(), 1.0;
    const Eigen::Vector3d error(x.dot(filter.normal()), y.dot(filter.normal()), errorAtCentroid(filter));
    const Eigen::Matrix3d covariance = jacobian * filter.covariance() * jacobian.transpose();
    nees += error.dot(covariance.inverse() * error) / kRuns;
    fused += error(2) * error(2) / kRuns;
    single += kDistance * kDistance / kRuns;
  }
  EXPECT_NEAR(3.0, nees, 0.4);
  EXPECT_NEAR(std::sqrt(0.1), std::sqrt(fused / single), 0.04);
}

TEST_F(Fusion, losesCertaintyWithTime) {
  FusionParameters parameters;
  PlaneTrackFilter filter(measured(0, 0, 0), pose_, parameters_);
  const double before = filter.covariance().trace();
  filter.predict(0.0, parameters);
  EXPECT_DOUBLE_EQ(before, filter.covariance().trace());
  filter.predict(10.0, parameters);
  EXPECT_GT(filter.covariance().trace(), before);
  parameters.fusion_drift_angle = parameters.fusion_drift_distance = 0.0;
  const double after = filter.covariance().trace();
  filter.predict(10.0, parameters);
  EXPECT_DOUBLE_EQ(after, filter.covariance().trace());
}

// The covariance with errors of the pose is that of measurements which are made with them.
TEST_F(Fusion, accountsForErrorsOfThePose) {
  parameters_.fusion_pose_angle = 1.0;
  parameters_.fusion_pose_distance = 0.02;
  Random random(21);
  const auto vector = [&random] {
    return Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian());
  };
  expectCovarianceOfPoses({}, [&](Eigen::Vector3d& turn, Eigen::Vector3d& shift) {
    turn = M_PI / 180.0 * vector();
    shift = 0.02 * vector();
  });
}

// The covariance with an error of the time is that of measurements with poses of another time.
TEST_F(Fusion, accountsForErrorsOfTimestamps) {
  parameters_.fusion_timestamp_error = 0.05;
  const CameraVelocity velocity{{0.3, -0.5, 0.4}, {0.2, -0.3, 0.6}};
  Random random(23);
  expectCovarianceOfPoses(velocity, [&](Eigen::Vector3d& turn, Eigen::Vector3d& shift) {
    const double late = 0.05 * random.gaussian();
    turn = late * velocity.angular;
    shift = late * velocity.linear;
  });
}

// Timestamps that are late by more than the tracker expects of a camera at rest: it turns to and fro at
// 60 degrees per second, and each orientation is three degrees ahead.
TEST_F(Fusion, holdsAPlaneWhileTheCameraTurns) {
  const double seconds = 1.0 / 30.0, rate = M_PI / 3.0, ahead = 0.05 * rate;
  parameters_.fusion_pose_angle = 0.5;
  PlaneTrackFilter filter(measured(0.0, 0.0, 0.0), pose_, parameters_);
  for (int i = 0; i < 120; ++i) {
    const double direction = i / 40 % 2 == 0 ? 1.0 : -1.0;
    CameraVelocity velocity;
    velocity.angular = direction * rate * (pose_.linear() * normal_.unitOrthogonal());
    Eigen::Isometry3d wrong = pose_;
    wrong.linear() = Eigen::AngleAxisd(ahead, velocity.angular.normalized()) * pose_.linear();
    filter.predict(seconds, parameters_);
    filter.update(measured(0.0, 0.0, 0.0), wrong, parameters_, velocity);
    EXPECT_LT(angleOf(trueNormal(), filter.normal()), 0.8 * ahead) << "image " << i;
  }
  EXPECT_GT(filter.observations(), 110U) << "no restart";
}

TEST(CameraVelocityTest, isThatBetweenTwoPoses) {
  Eigen::Isometry3d first = Eigen::Isometry3d::Identity();
  first.translate(Eigen::Vector3d(5.0, -2.0, 1.0)).rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitX()));
  const Eigen::Vector3d angular(0.1, -0.7, 0.4), linear(0.3, 0.2, -0.5);
  Eigen::Isometry3d second = first;
  second.linear() = Eigen::AngleAxisd(0.25 * angular.norm(), angular.normalized()) * first.linear();
  second.translation() += 0.25 * linear;
  const CameraVelocity velocity = CameraVelocity::between(first, second, 0.25);
  EXPECT_NEAR(0.0, (velocity.angular - angular).norm(), 1e-9);
  EXPECT_NEAR(0.0, (velocity.linear - linear).norm(), 1e-9);
  EXPECT_EQ(0.0, CameraVelocity::between(first, second, 0.0).angular.norm());
  EXPECT_EQ(0.0, CameraVelocity::between(first, second, -1.0).linear.norm());
}

TEST_F(Fusion, withstandsAnOutlier) {
  Random random(7);
  PlaneTrackFilter filter(noisy(random), pose_, parameters_);
  for (int i = 1; i < 10; ++i) filter.update(noisy(random), pose_, parameters_);
  EXPECT_GT(filter.update(measured(0.3, 0.0, 0.2), pose_, parameters_), 100.0);
  EXPECT_LT(angleOf(trueNormal(), filter.normal()), 2.0 * kAngle);
  EXPECT_LT(std::abs(errorAtCentroid(filter)), 2.0 * kDistance);
}

TEST_F(Fusion, followsAPlaneThatHasMoved) {
  Random random(9);
  PlaneTrackFilter filter(noisy(random), pose_, parameters_);
  for (int i = 1; i < 50; ++i) filter.update(noisy(random), pose_, parameters_);
  for (int i = 0; i < 35; ++i) filter.update(measured(0.2, 0.0, 0.1), pose_, parameters_);
  EXPECT_NEAR(std::atan(0.2), angleOf(trueNormal(), filter.normal()), 0.5 * kAngle);
  EXPECT_NEAR(0.1, errorAtCentroid(filter), 0.5 * kDistance);
  EXPECT_LT(filter.observations(), 20U) << "it started anew";
}

TEST_F(Fusion, givesTheSameFromAnotherPose) {
  Random random(11);
  PlaneTrackFilter filter(noisy(random), pose_, parameters_);
  const SegmentedPlane plane = noisy(random);
  PlaneTrackFilter other = filter;
  filter.update(plane, pose_, parameters_);

  // The same measurement as another camera would have it.
  const Eigen::Isometry3d moved =
      pose_ * Eigen::Translation3d(0.3, -0.4, 0.5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY());
  const Eigen::Isometry3d there = moved.inverse() * pose_;
  SegmentedPlane same = plane;
  same.normal = there.linear() * plane.normal;
  same.d = plane.d - same.normal.dot(there.translation());
  same.centroid = there * plane.centroid;
  Eigen::Matrix4d jacobian = Eigen::Matrix4d::Identity();
  jacobian.topLeftCorner<3, 3>() = there.linear();
  jacobian.bottomLeftCorner<1, 3>() = -there.translation().transpose() * there.linear();
  same.covariance = jacobian * plane.covariance * jacobian.transpose();
  other.update(same, moved, parameters_);
  EXPECT_NEAR(0.0, angleOf(filter.normal(), other.normal()), 1e-9);
  EXPECT_NEAR(filter.d(), other.d(), 1e-7);
}

TEST_F(Fusion, takesAMeasurementWithoutCovariance) {
  SegmentedPlane plane = measured(0.01, 0.01, 0.01);
  plane.covariance.setZero();
  PlaneTrackFilter filter(measured(0, 0, 0), pose_, parameters_);
  filter.update(plane, pose_, parameters_);
  EXPECT_NEAR(0.0, angleOf(pose_.linear() * plane.normal, filter.normal()), 1e-4);
  EXPECT_TRUE(filter.covariance().allFinite());
}

TEST_F(Fusion, staysFiniteAndPositiveOverManyImages) {
  Random random(13);
  FusionParameters parameters;
  PlaneTrackFilter filter(noisy(random), pose_, parameters_);
  for (int i = 0; i < 20000; ++i) {
    filter.predict(1.0 / 30.0, parameters);
    filter.update(noisy(random), pose_, parameters_);
  }
  EXPECT_NEAR(1.0, filter.normal().norm(), 1e-12);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(filter.covariance());
  EXPECT_GT(eigen.eigenvalues()(1), 0.0) << "rank 3";
  EXPECT_LT(angleOf(trueNormal(), filter.normal()), kAngle);
}

}  // namespace
}  // namespace line_plane_segmentation
