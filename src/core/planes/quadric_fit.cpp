// SPDX-License-Identifier: BSD-3-Clause
#include "planes/quadric_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>

namespace line_plane_segmentation {

void QuadricFit::add(double x, double y, double deviation) {
  const double xx = x * x, xy = x * y, yy = y * y;
  const std::array<double, 15> powers = {1.0,    x,      y,       xx,      xy,      yy,      xx * x, xx * y,
                                         x * yy, yy * y, xx * xx, xx * xy, xx * yy, xy * yy, yy * yy};
  for (std::size_t i = 0; i < powers_.size(); ++i) powers_[i] += powers[i];
  for (std::size_t i = 0; i < with_deviation_.size(); ++i) with_deviation_[i] += deviation * powers[i];
  squares_ += deviation * deviation;
  ++points_;
}

double QuadricFit::variance() const {
  assert(points_ > 6);
  // The powers that the products of the terms 1, x, y, x², xy, y² are.
  constexpr std::array<std::array<std::size_t, 6>, 6> kPower = {{{0, 1, 2, 3, 4, 5},
                                                                 {1, 3, 4, 6, 7, 8},
                                                                 {2, 4, 5, 7, 8, 9},
                                                                 {3, 6, 7, 10, 11, 12},
                                                                 {4, 7, 8, 11, 12, 13},
                                                                 {5, 8, 9, 12, 13, 14}}};
  Eigen::Matrix<double, 6, 6> products;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) products(i, j) = powers_[kPower[i][j]];
  }
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> with_deviation(with_deviation_.data());
  const double explained = products.ldlt().solve(with_deviation).dot(with_deviation);
  return std::max(0.0, squares_ - explained) / (points_ - 6);
}

}  // namespace line_plane_segmentation
