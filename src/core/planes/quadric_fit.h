// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace line_plane_segmentation {

/// Least-squares fit of a quadric surface, deviation = polynomial of second degree in (x, y): tells a curved
/// surface from a plane with noise.
class QuadricFit {
 public:
  /// Adds a point at the ray (x, y), with its deviation from a plane.
  void add(double x, double y, double deviation);

  int points() const { return points_; }

  /// Variance of the deviations about the surface, per degree of freedom.
  /// @pre at least 7 points
  double variance() const;

 private:
  Eigen::Matrix<double, 6, 6> products_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> with_deviation_ = Eigen::Matrix<double, 6, 1>::Zero();
  double squares_ = 0.0;
  int points_ = 0;
};

}  // namespace line_plane_segmentation
