// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/surface_bend.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>

namespace line_plane_segmentation {

void SurfaceBend::add(double u, double v, double deviation) {
  Eigen::Matrix<double, 6, 1> terms;
  terms << 1.0, u, v, u * u, u * v, v * v;
  products_ += terms * terms.transpose();
  with_deviation_ += deviation * terms;
  squares_ += deviation * deviation;
  ++points_;
}

SurfaceBend::Residuals SurfaceBend::fit() const {
  assert(points_ > 6);
  const Eigen::Vector3d linear = products_.topLeftCorner<3, 3>().ldlt().solve(with_deviation_.head<3>());
  const Eigen::Matrix<double, 6, 1> quadratic = products_.ldlt().solve(with_deviation_);
  const double plane = squares_ - linear.dot(with_deviation_.head<3>());
  const double quadric = squares_ - quadratic.dot(with_deviation_);
  return {std::max(0.0, plane) / (points_ - 3), std::max(0.0, quadric) / (points_ - 6)};
}

}  // namespace line_plane_segmentation
