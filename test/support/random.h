// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>

namespace line_plane_segmentation {

/// Random numbers that are the same with every compiler and library, unlike those of std's distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }

  /// From low to high, both included.
  int integer(int low, int high) { return low + static_cast<int>(uniform(0.0, high - low + 1.0)); }

  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  /// Mean 0, standard deviation 1 (Box and Muller).
  double gaussian() {
    constexpr double kTwoPi = 6.283185307179586;
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return radius * std::cos(kTwoPi * uniform(0.0, 1.0));
  }

  Eigen::Vector3d direction() { return Eigen::Vector3d(gaussian(), gaussian(), gaussian()).normalized(); }

 private:
  std::mt19937_64 bits_;
};

}  // namespace line_plane_segmentation
