// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace line_plane_segmentation {

/// Sums over points, from which a plane is fitted in constant time.
struct PointMoments {
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();    ///< [m]
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();  ///< [m²] sum of p p^T

  void add(const Eigen::Vector3d& p) {
    count += 1.0;
    sum += p;
    outer += p * p.transpose();
  }

  /// [m²] of the points to the plane normal . p + d = 0; there must be points.
  double meanSquareDistance(const Eigen::Vector3d& normal, double d) const;

  PointMoments& operator+=(const PointMoments& other) {
    count += other.count;
    sum += other.sum;
    outer += other.outer;
    return *this;
  }
};

/// A plane by principal component analysis.
struct PlaneFit {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   ///< unit, toward the camera
  double d = 0.0;                                      ///< [m] normal . p + d = 0, not negative
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< [m]
  double mean_square = 0.0;                            ///< [m²] of the points' distances
  double curvature = 0.0;                              ///< smallest eigenvalue over the sum of all three

  /// Covariance of (normal, d), each point being displaced across the plane by `sigma` [m].
  Eigen::Matrix4d covariance(const PointMoments& moments, double sigma) const;
};

/// The plane whose squared distances to the points are least.
/// @return false if the points do not span a plane: fewer than three, or all on one line
bool fitPlane(const PointMoments& moments, PlaneFit& plane);

}  // namespace line_plane_segmentation
