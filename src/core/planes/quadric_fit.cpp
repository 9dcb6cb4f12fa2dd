// SPDX-License-Identifier: BSD-3-Clause
#include "planes/quadric_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>

namespace line_plane_segmentation {

void QuadricFit::add(double x, double y, double deviation) {
  Eigen::Matrix<double, 6, 1> terms;
  terms << 1.0, x, y, x * x, x * y, y * y;
  products_ += terms * terms.transpose();
  with_deviation_ += deviation * terms;
  squares_ += deviation * deviation;
  ++points_;
}

double QuadricFit::variance() const {
  assert(points_ > 6);
  const Eigen::Matrix<double, 6, 1> coefficients = products_.ldlt().solve(with_deviation_);
  return std::max(0.0, squares_ - coefficients.dot(with_deviation_)) / (points_ - 6);
}

}  // namespace line_plane_segmentation
