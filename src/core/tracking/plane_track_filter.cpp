// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_track_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr double kPi = 3.14159265358979323846;

constexpr double kGate = 11.345;  // 99 % quantile of the chi-squared distribution with 3 degrees of freedom
constexpr int kMaxOutliers = 30;  // in a row: a fast rotation with late timestamps takes a second

// Least standard deviations of a measurement, also for planes whose covariance was not computed: [rad], [m].
constexpr double kLeastAngle = 1e-4;
constexpr double kLeastOffset = 1e-4;

double radians(double degrees) { return degrees * kPi / 180.0; }

Eigen::Matrix<double, 3, 2> tangentOf(const Eigen::Vector3d& normal) {
  Eigen::Matrix<double, 3, 2> tangent;
  tangent.col(0) = normal.unitOrthogonal();
  tangent.col(1) = normal.cross(tangent.col(0));
  return tangent;
}

}  // namespace

CameraVelocity CameraVelocity::between(const Eigen::Isometry3d& first, const Eigen::Isometry3d& second,
                                       double seconds) {
  CameraVelocity velocity;
  if (!(seconds > 0.0)) return velocity;
  const Eigen::AngleAxisd turn(second.linear() * first.linear().transpose());
  velocity.angular = turn.angle() / seconds * turn.axis();
  velocity.linear = (second.translation() - first.translation()) / seconds;
  return velocity;
}

struct PlaneTrackFilter::Measurement {
  Eigen::Vector3d normal;      // in the fixed frame
  double offset;               // [m] at the anchor
  Eigen::Matrix3d covariance;  // as that of the state
};

// The covariance of (n, d) goes from the optical frame to the anchor directly. In the fixed frame it would
// have large terms that cancel, if the frame's origin is far away.
PlaneTrackFilter::Measurement PlaneTrackFilter::measurementOf(const SegmentedPlane& measured,
                                                              const Eigen::Isometry3d& fixed_from_optical,
                                                              const FusionParameters& parameters,
                                                              const CameraVelocity& velocity) const {
  const Eigen::Vector3d anchor = fixed_from_optical.inverse() * anchor_;
  Measurement measurement;
  measurement.normal = fixed_from_optical.linear() * measured.normal;
  measurement.offset = measured.normal.dot(anchor) + measured.d;
  Eigen::Matrix<double, 3, 4> jacobian = Eigen::Matrix<double, 3, 4>::Zero();
  jacobian.topLeftCorner<2, 3>() = tangent_.transpose() * fixed_from_optical.linear();
  jacobian.bottomLeftCorner<1, 3>() = anchor.transpose();
  jacobian(2, 3) = 1.0;
  measurement.covariance = jacobian * measured.covariance * jacobian.transpose();

  // An error in the camera's orientation, a rotation r about the camera, turns the normal by r x n and moves
  // the plane at the anchor by r . (n x ray).
  const Eigen::Vector3d& n = measurement.normal;
  const Eigen::Vector3d ray = anchor_ - fixed_from_optical.translation();
  Eigen::Matrix3d of_rotation;
  of_rotation.row(0) = n.cross(tangent_.col(0));
  of_rotation.row(1) = n.cross(tangent_.col(1));
  of_rotation.row(2) = n.cross(ray);
  const double angle = radians(parameters.fusion_pose_angle);
  measurement.covariance += angle * angle * of_rotation * of_rotation.transpose();
  // An error in the timestamp moves the camera along its path.
  Eigen::Vector3d of_time = of_rotation * velocity.angular;
  of_time(2) -= n.dot(velocity.linear);
  const double time = parameters.fusion_timestamp_error;
  measurement.covariance += time * time * of_time * of_time.transpose();
  measurement.covariance(2, 2) += parameters.fusion_pose_distance * parameters.fusion_pose_distance;

  measurement.covariance.diagonal() +=
      Eigen::Vector3d(kLeastAngle * kLeastAngle, kLeastAngle * kLeastAngle, kLeastOffset * kLeastOffset);
  return measurement;
}

PlaneTrackFilter::PlaneTrackFilter(const SegmentedPlane& measured,
                                   const Eigen::Isometry3d& fixed_from_optical,
                                   const FusionParameters& parameters, const CameraVelocity& velocity) {
  start(measured, fixed_from_optical, parameters, velocity);
}

void PlaneTrackFilter::start(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                             const FusionParameters& parameters, const CameraVelocity& velocity) {
  anchor_ = fixed_from_optical * measured.centroid;
  normal_ = (fixed_from_optical.linear() * measured.normal).normalized();
  tangent_ = tangentOf(normal_);
  const Measurement measurement = measurementOf(measured, fixed_from_optical, parameters, velocity);
  offset_ = measurement.offset;
  covariance_ = measurement.covariance;
  observations_ = 1;
  outliers_ = 0;
}

void PlaneTrackFilter::predict(double seconds, const FusionParameters& parameters) {
  const double angle = radians(parameters.fusion_drift_angle);
  const double distance = parameters.fusion_drift_distance;
  covariance_.diagonal() += seconds * Eigen::Vector3d(angle * angle, angle * angle, distance * distance);
}

// Turns the normal by a rotation vector in the tangent plane.
void PlaneTrackFilter::rotate(const Eigen::Vector2d& vector) {
  const double angle = vector.norm();
  if (!(angle > 0.0)) return;
  const Eigen::Vector3d toward = tangent_ * vector / angle;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, normal_.cross(toward)).toRotationMatrix();
  normal_ = (rotation * normal_).normalized();
  tangent_ = rotation * tangent_;
  // Rounding accumulates over thousands of images.
  tangent_.col(0) = (tangent_.col(0) - tangent_.col(0).dot(normal_) * normal_).normalized();
  tangent_.col(1) = normal_.cross(tangent_.col(0));
}

double PlaneTrackFilter::update(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                                const FusionParameters& parameters, const CameraVelocity& velocity) {
  Measurement measurement = measurementOf(measured, fixed_from_optical, parameters, velocity);
  if (measurement.normal.dot(normal_) < 0.0) {
    measurement.normal = -measurement.normal;
    measurement.offset = -measurement.offset;
  }
  // The rotation vector that turns the normal into the measured one, as the state has it.
  const Eigen::Vector2d across = tangent_.transpose() * measurement.normal;
  const double sine = across.norm();
  const double angle = std::atan2(sine, measurement.normal.dot(normal_));
  Eigen::Vector3d innovation;
  innovation.head<2>() = sine > 0.0 ? (angle / sine * across).eval() : across;
  innovation(2) = measurement.offset - offset_;

  const double distance = innovation.dot((covariance_ + measurement.covariance).inverse() * innovation);
  const bool is_outlier = distance > kGate;
  outliers_ = is_outlier ? outliers_ + 1 : 0;
  // Few measurements may be the wrong ones themselves: of two planes, seen as one.
  const int most = observations_ < kMaxOutliers / 2 ? 2 * static_cast<int>(observations_) : kMaxOutliers;
  if (outliers_ > most || !std::isfinite(distance)) {
    start(measured, fixed_from_optical, parameters, velocity);
    return distance;
  }
  measurement.covariance *= std::max(1.0, distance / kGate);

  const Eigen::Matrix3d gain = covariance_ * (covariance_ + measurement.covariance).inverse();
  const Eigen::Vector3d step = gain * innovation;
  // Joseph's form, which stays symmetric and positive.
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - gain;
  covariance_ = rest * covariance_ * rest.transpose() + gain * measurement.covariance * gain.transpose();
  offset_ += step(2);
  rotate(step.head<2>());
  if (!is_outlier) ++observations_;
  return distance;
}

Eigen::Matrix4d PlaneTrackFilter::covariance() const {
  // d = offset - n . anchor.
  Eigen::Matrix<double, 4, 3> jacobian = Eigen::Matrix<double, 4, 3>::Zero();
  jacobian.topLeftCorner<3, 2>() = tangent_;
  jacobian.bottomLeftCorner<1, 2>() = -anchor_.transpose() * tangent_;
  jacobian(3, 2) = 1.0;
  return jacobian * covariance_ * jacobian.transpose();
}

}  // namespace line_plane_segmentation
