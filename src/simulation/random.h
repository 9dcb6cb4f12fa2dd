// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace line_plane_segmentation::simulation {

/// Hashes `x` so that consecutive numbers give unrelated results: the finalizer of splitmix64 (Steele, Lea,
/// Flood 2014).
constexpr std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// Random bits that depend on nothing but the key and the counter, so that a pixel's noise is the same
/// in any order, part or thread in which the image is made.
constexpr std::uint64_t randomBits(std::uint64_t key, std::uint64_t counter) {
  return mixBits(key + (counter + 1) * 0x9e3779b97f4a7c15U);
}

/// Converts random bits to a uniform number in [0, 1).
constexpr double toUniform(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

/// Number of set bits (std::popcount in C++20).
constexpr int countOnes(std::uint64_t x) {
  x -= (x >> 1) & 0x5555555555555555U;
  x = (x & 0x3333333333333333U) + ((x >> 2) & 0x3333333333333333U);
  x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  return static_cast<int>((x * 0x0101010101010101U) >> 56);
}

/// Converts two independent random words to a number of the normal distribution N(0, 1).
///
/// std::normal_distribution differs between standard libraries, and logarithm and sine differ in their last
/// bit. This function adds the number of set bits of 64 (variance 16) and the sum of two uniform numbers
/// (variance 1/6). The result has an excess kurtosis of -0.03 and no value beyond 8.2.
constexpr double toNormal(std::uint64_t tosses, std::uint64_t fill) {
  constexpr double kInverseDeviation = 0.24871091705255086;  // 1 / sqrt(16 + 1/6)
  const double heads = countOnes(tosses) - 32;
  const double low = static_cast<std::int32_t>(fill & 0xffffffffU);
  const double high = static_cast<std::int32_t>(fill >> 32);
  return (heads + (low + high + 1.0) * 0x1.0p-32) * kInverseDeviation;
}

/// Sequence of random numbers, the same on every machine.
class Random {
 public:
  /// Starts the sequence of this seed.
  explicit Random(std::uint64_t seed) : key_(mixBits(seed)) {}

  /// @return uniform in [min, max)
  double uniform(double min, double max) {
    return min + (max - min) * toUniform(randomBits(key_, counter_++));
  }

  /// @return true with the given probability
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace line_plane_segmentation::simulation
