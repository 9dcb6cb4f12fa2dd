// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Errors of the camera's pose in the fixed frame, which planes are fused in.
struct FusionParameters {
  double fusion_pose_angle =
      0.5;  ///< [deg] standard deviation of its orientation in one image, about each axis
  double fusion_pose_distance = 0.01;  ///< [m] standard deviation of its position in one image
  double fusion_drift_angle = 0.1;  ///< [deg/sqrt(s)] drift of its orientation: process noise of the normals
  double fusion_drift_distance = 0.003;  ///< [m/sqrt(s)] drift of its position: process noise of the offsets
};

/// As visitParameters() for the method's parameters: the one list of names and bounds.
template <typename ParametersType, typename Visitor>
void visitFusionParameters(ParametersType& p, Visitor&& visitor) {
  visitor("fusion_pose_angle", p.fusion_pose_angle, 0.0, 90.0);
  visitor("fusion_pose_distance", p.fusion_pose_distance, 0.0, 10.0);
  visitor("fusion_drift_angle", p.fusion_drift_angle, 0.0, 90.0);
  visitor("fusion_drift_distance", p.fusion_drift_distance, 0.0, 10.0);
}

/// A Kalman filter of one plane that stands still in a fixed frame, observed by a camera that moves.
///
/// The state is minimal: two rotations of the unit normal about axes in its tangent plane, and the offset
/// along the normal at an anchor, a point of the plane's first observation. The anchor keeps the offset
/// independent of the distance to the frame's origin. A measurement beyond the 99 % quantile of its
/// Mahalanobis distance is weighted down to that quantile, as a Huber estimator does; after 30 of them
/// in a row, or two for each that fits, the filter starts anew at the last.
class PlaneTrackFilter {
 public:
  /// Starts with a first measurement.
  /// @param measured            with a covariance, in the camera's optical frame
  /// @param fixed_from_optical  pose of the camera in the fixed frame
  PlaneTrackFilter(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                   const FusionParameters& parameters);

  /// Adds the process noise of a time span.
  /// @param seconds  [s] not negative
  void predict(double seconds, const FusionParameters& parameters);

  /// Fuses a measurement, as for the constructor. A plane that faces the other way is taken as its own
  /// negative.
  /// @return squared Mahalanobis distance between measurement and prediction; 3 degrees of freedom
  double update(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                const FusionParameters& parameters);

  /// Coefficients in the fixed frame: n . p + d = 0, the unit normal toward the camera.
  const Eigen::Vector3d& normal() const { return normal_; }
  double d() const { return offset_ - normal_.dot(anchor_); }

  /// Covariance of (n, d) in the fixed frame, of rank 3.
  Eigen::Matrix4d covariance() const;

  /// Orthogonal projection of a point of the fixed frame onto the plane.
  Eigen::Vector3d projected(const Eigen::Vector3d& point) const {
    return point - (normal_.dot(point - anchor_) + offset_) * normal_;
  }

  /// Measurements since the filter started, or started anew.
  std::uint32_t observations() const { return observations_; }

 private:
  struct Measurement;
  Measurement measurementOf(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
                            const FusionParameters& parameters) const;
  void start(const SegmentedPlane& measured, const Eigen::Isometry3d& fixed_from_optical,
             const FusionParameters& parameters);

  Eigen::Vector3d anchor_;               // [m] in the fixed frame
  Eigen::Vector3d normal_;               // unit, in the fixed frame
  double offset_ = 0.0;                  // [m] normal . anchor + d
  Eigen::Matrix<double, 3, 2> tangent_;  // basis of the tangent plane of the normal
  Eigen::Matrix3d covariance_;           // of (rotation [rad], rotation [rad], offset [m])
  std::uint32_t observations_ = 0;
  int outliers_ = 0;  // in a row
};

}  // namespace line_plane_segmentation
