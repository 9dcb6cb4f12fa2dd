// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Errors of the camera's pose in the fixed frame, in which planes are fused.
struct FusionParameters {
  /// [deg] Standard deviation of the camera's orientation in one image. Increase to smooth more;
  /// decrease to follow changes faster.
  double fusion_pose_angle = 0.5;
  /// [m] Standard deviation of the camera's position in one image. Increase to smooth more;
  /// decrease to follow changes faster.
  double fusion_pose_distance = 0.01;
  /// [deg/sqrt(s)] Process noise of a normal, caused by drift of the camera's pose. Increase to
  /// follow changes faster; decrease to smooth more.
  double fusion_drift_angle = 0.1;
  /// [m/sqrt(s)] Process noise of a plane's offset, caused by drift of the camera's pose. Increase
  /// to follow changes faster; decrease to smooth more.
  double fusion_drift_distance = 0.003;
  /// [s] Standard deviation of the images' timestamps against those of the camera's pose: while the camera
  /// moves, its pose is off by what it moves in that time. Increase to rely less on images of a moving
  /// camera; decrease to rely more on them.
  double fusion_timestamp_error = 0.033;
};

/// Calls `visitor(name, value, min, max)` for each parameter, as visitParameters() does for the method's.
template <typename ParametersType, typename Visitor>
void visitFusionParameters(ParametersType& p, Visitor&& visitor) {
  visitor("fusion_pose_angle", p.fusion_pose_angle, 0.0, 90.0);
  visitor("fusion_pose_distance", p.fusion_pose_distance, 0.0, 10.0);
  visitor("fusion_timestamp_error", p.fusion_timestamp_error, 0.0, 10.0);
  visitor("fusion_drift_angle", p.fusion_drift_angle, 0.0, 90.0);
  visitor("fusion_drift_distance", p.fusion_drift_distance, 0.0, 10.0);
}

/// Velocity of the camera in the fixed frame.
struct CameraVelocity {
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< [m/s] of the optical centre

  /// Mean velocity between two poses, or zero if the time is not positive.
  /// @param seconds  [s] from the first pose to the second
  static CameraVelocity between(const Eigen::Isometry3d& first, const Eigen::Isometry3d& second,
                                double seconds);
};

/// Kalman filter of one static plane in a fixed frame, observed by a moving camera.
///
/// The state is minimal: two rotations of the unit normal about axes in its tangent plane, and the offset
/// along the normal at an anchor, a point of the plane's first observation. The anchor keeps the offset
/// independent of the distance to the frame's origin. A measurement beyond the 99 % quantile of its
/// Mahalanobis distance is an outlier and is weighted down to that quantile, as by a Huber estimator. After
/// 30 consecutive outliers, or two outliers per inlier, the filter restarts at the last measurement.
class PlaneTrackFilter {
 public:
  /// Initialises the state with a first measurement.
  /// @param measured            plane with covariance in the camera's optical frame
  /// @param fixed_from_optical  pose of the camera in the fixed frame
  /// @param velocity            of the camera; zero leaves out the error of timestamps
  PlaneTrackFilter(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                   const FusionParameters& parameters, const CameraVelocity& velocity = {});

  /// Adds the process noise of a time span.
  /// @param seconds  [s] not negative
  void predict(double seconds, const FusionParameters& parameters);

  /// Fuses a measurement, given as in the constructor. The sign of a plane with the opposite normal is
  /// changed.
  /// @return squared Mahalanobis distance between measurement and prediction; 3 degrees of freedom
  double update(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                const FusionParameters& parameters, const CameraVelocity& velocity = {});

  /// Coefficients in the fixed frame: n . p + d = 0, the unit normal toward the camera.
  const Eigen::Vector3d& normal() const { return normal_; }
  double d() const { return offset_ - normal_.dot(anchor_); }

  /// Covariance of (n, d) in the fixed frame, of rank 3.
  Eigen::Matrix4d covariance() const;

  /// Orthogonal projection of a point of the fixed frame onto the plane.
  Eigen::Vector3d projected(const Eigen::Vector3d& point) const {
    return point - (normal_.dot(point - anchor_) + offset_) * normal_;
  }

  /// Returns the number of measurements since the start or the last restart.
  std::uint32_t observations() const { return observations_; }

 private:
  struct Measurement;
  Measurement measurementOf(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                            const FusionParameters& parameters, const CameraVelocity& velocity) const;
  void start(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
             const FusionParameters& parameters, const CameraVelocity& velocity);
  void rotate(const Eigen::Vector2d& vector);

  Eigen::Vector3d anchor_;               // [m] in the fixed frame
  Eigen::Vector3d normal_;               // unit, in the fixed frame
  double offset_ = 0.0;                  // [m] normal . anchor + d
  Eigen::Matrix<double, 3, 2> tangent_;  // basis of the tangent plane of the normal
  Eigen::Matrix3d covariance_;           // of (rotation [rad], rotation [rad], offset [m])
  std::uint32_t observations_ = 0;
  int outliers_ = 0;  // in a row
};

}  // namespace line_plane_segmentation
