// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace line_plane_segmentation::simulation {
namespace {

std::vector<double> normals(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(toNormal(randomBits(5, 2 * i), randomBits(5, 2 * i + 1)));
  return values;
}

// The values that splitmix64 gives for the seed 0, as its authors publish them.
TEST(Random, GivesTheSameBitsOnEveryMachine) {
  EXPECT_EQ(randomBits(0, 0), 0xe220a8397b1dcdafU);
  EXPECT_EQ(randomBits(0, 1), 0x6e789e6aa1b965f4U);
  EXPECT_EQ(randomBits(0, 2), 0x06c45d188009454fU);
}

TEST(Random, CountsOnes) {
  EXPECT_EQ(countOnes(0), 0);
  EXPECT_EQ(countOnes(1), 1);
  EXPECT_EQ(countOnes(0x8000000000000001U), 2);
  EXPECT_EQ(countOnes(~std::uint64_t{0}), 64);
}

TEST(Random, UniformFillsItsRange) {
  Random random(3);
  double sum = 0.0;
  double min = 10.0;
  double max = -10.0;
  for (int i = 0; i < 10000; ++i) {
    const double value = random.uniform(-2.0, 4.0);
    min = std::min(min, value);
    max = std::max(max, value);
    sum += value;
  }
  EXPECT_GE(min, -2.0);
  EXPECT_LT(min, -1.99);
  EXPECT_LT(max, 4.0);
  EXPECT_GT(max, 3.99);
  EXPECT_NEAR(sum / 10000, 1.0, 0.06);  // 3.5 deviations of the mean
}

TEST(Random, SeedsGiveUnrelatedStreams) {
  std::set<double> firsts;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) firsts.insert(Random(seed).uniform(0.0, 1.0));
  EXPECT_EQ(firsts.size(), 1000U);
  EXPECT_LT(*firsts.begin(), 0.02);
  EXPECT_GT(*firsts.rbegin(), 0.98);
}

TEST(Random, NormalHasTheMomentsOfTheNormalDistribution) {
  constexpr std::size_t kCount = 1000000;
  double sums[5] = {};
  for (const double x : normals(kCount)) {
    for (int power = 1; power <= 4; ++power) sums[power] += std::pow(x, power);
  }
  EXPECT_NEAR(sums[1] / kCount, 0.0, 0.004);
  EXPECT_NEAR(sums[2] / kCount, 1.0, 0.006);
  EXPECT_NEAR(sums[3] / kCount, 0.0, 0.012);
  EXPECT_NEAR(sums[4] / kCount, 3.0, 0.07);  // 2.97 by construction
}

// Kolmogorov and Smirnov's distance: 0.0016 is what pure chance exceeds once in 100 times, and 0.0007 is due
// to the kurtosis (Edgeworth's series). Four uniform numbers added would be 0.007 away.
TEST(Random, NormalHasTheShapeOfTheNormalDistribution) {
  constexpr std::size_t kCount = 1000000;
  std::vector<double> values = normals(kCount);
  std::sort(values.begin(), values.end());
  double distance = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double expected = 0.5 * std::erfc(-values[i] / std::sqrt(2.0));
    distance = std::max(distance, std::abs(expected - static_cast<double>(i) / kCount));
  }
  EXPECT_LT(distance, 0.0023);
  EXPECT_LT(values.front(), -4.4);
  EXPECT_GT(values.back(), 4.4);
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
