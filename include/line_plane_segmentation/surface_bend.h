// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace line_plane_segmentation {

/// Tells a curved surface that looks nearly flat from a plane with noise: how much of the deviations from a
/// plane a quadratic surface explains.
class SurfaceBend {
 public:
  /// Adds a point: its place in the picture, in units that keep the fourth power small, and how far it
  /// lies off the plane.
  void add(double u, double v, double deviation);

  int points() const { return points_; }

  /// What is left of the mean squared deviation, for each degree of freedom, beside a plane and beside a
  /// quadratic surface, both fitted to the points. Needs at least 7 points.
  struct Residuals {
    double plane = 0.0, quadric = 0.0;
  };
  Residuals fit() const;

 private:
  Eigen::Matrix<double, 6, 6> products_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> with_deviation_ = Eigen::Matrix<double, 6, 1>::Zero();
  double squares_ = 0.0;
  int points_ = 0;
};

}  // namespace line_plane_segmentation
