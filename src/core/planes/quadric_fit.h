// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

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
  std::array<double, 15> powers_{};         // sums of 1, x, y, x², xy, y², x³, x²y ... y⁴
  std::array<double, 6> with_deviation_{};  // sums of 1, x, y, x², xy, y², times the deviation
  double squares_ = 0.0;
  int points_ = 0;
};

}  // namespace line_plane_segmentation
