// SPDX-License-Identifier: BSD-3-Clause
#include "kinect_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>

#include "noise_pictures.h"

namespace line_plane_segmentation::simulation {
namespace {

constexpr double kLevelDepth = 8.0 * 580.0 * 0.075;  // [m] of disparity level 1

KinectNoiseParameters onlyAxial() {
  KinectNoiseParameters p = allOff();
  p.axial = NoiseParameters();
  return p;
}

struct Statistics {
  double mean = 0.0;   // [m]
  double sigma = 0.0;  // [m]
};

/// Of an image without missing pixels.
Statistics statisticsOf(const Image& mm) {
  const auto count = static_cast<double>(mm.size());
  Statistics result;
  for (const std::uint16_t pixel : mm) result.mean += 1e-3 * pixel / count;
  double sum = 0.0;
  for (const std::uint16_t pixel : mm) sum += std::pow(1e-3 * pixel - result.mean, 2);
  result.sigma = std::sqrt(sum / (count - 1.0));
  return result;
}

TEST(KinectNoise, SwitchedOffItIsTheExactImage) {
  const Room room = simulatedRoom(2);
  const Rendering picture = pictureOf(room.scene, room.path.pose(4.0));
  Image exact(picture.depth.size());
  toMillimetres(picture, exact.data());
  EXPECT_EQ(apply(allOff(), picture), exact);
}

// The sample deviation of 307200 pixels is itself right to 0.13 %; rounding to millimetres adds its share.
TEST(KinectNoise, AxialDeviationIsThatOfEquation5) {
  for (const double z : {0.8, 1.5, 3.0, 5.0, 8.0}) {
    SCOPED_TRACE(z);
    const double expected = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    const Statistics measured = statisticsOf(apply(onlyAxial(), wallAt(z)));
    EXPECT_NEAR(measured.sigma, std::sqrt(expected * expected + 1e-6 / 12.0), 0.006 * expected);
    EXPECT_NEAR(measured.mean, z, 0.01 * expected);
  }
}

// What one depth's deviation is depends on where it lies between two levels, and on how these are rounded to
// millimetres. Over many places in many levels it is that of Eq. 5.
TEST(KinectNoise, QuantisationIsPartOfEquation5) {
  KinectNoiseParameters p = onlyAxial();
  p.disparity_step = 0.125;
  constexpr int kPlaces = 80;
  constexpr double kLevels = 7.0;
  for (const double z : {1.0, 1.5, 3.0, 5.0, 7.0}) {
    SCOPED_TRACE(z);
    double bias = 0.0;
    double square = 0.0;
    for (int place = 0; place < kPlaces; ++place) {
      const double disparity = kLevelDepth / z + kLevels * ((place + 0.5) / kPlaces - 0.5);
      const double true_depth = kLevelDepth / disparity;
      const double sigma = p.axial.sigma(true_depth);
      const Image mm = apply(p, wallAt(true_depth, 160, 120), 1, static_cast<std::uint64_t>(place));
      const Statistics measured = statisticsOf(mm);
      const double error = measured.mean - true_depth;
      bias += error / sigma / kPlaces;
      square += (error * error + measured.sigma * measured.sigma) / (sigma * sigma + 1e-6 / 12.0) / kPlaces;
    }
    EXPECT_NEAR(std::sqrt(square), 1.0, 0.03);
    EXPECT_NEAR(bias, 0.0, 0.05);
  }
}

// Khoshelham and Elberink (2012), section 3.2: steps of 2.85e-5 z^2 with z in centimetres.
TEST(KinectNoise, DepthsComeInTheKinectsLevels) {
  KinectNoiseParameters p = onlyAxial();
  p.disparity_step = 0.125;
  for (const double z : {1.0, 2.0, 4.0, 7.0}) {
    SCOPED_TRACE(z);
    const Image mm = apply(p, wallAt(z));
    const std::set<std::uint16_t> levels(mm.begin(), mm.end());
    ASSERT_GE(levels.size(), 4U);
    for (const std::uint16_t level : levels) {
      const double steps = std::round(kLevelDepth / (1e-3 * level));
      EXPECT_EQ(level, static_cast<int>(std::round(1e3 * kLevelDepth / steps)));
    }
    const auto above = levels.lower_bound(static_cast<std::uint16_t>(1000.0 * z));
    ASSERT_TRUE(above != levels.begin() && above != levels.end());
    EXPECT_NEAR(*above - *std::prev(above), 2.85 * z * z, 0.05 * 2.85 * z * z + 1.0);
  }
}

TEST(KinectNoise, PixelsAndFramesAreIndependent) {
  const Rendering wall = wallAt(3.0);
  const Image first = apply(onlyAxial(), wall, 1, 0);
  const Image second = apply(onlyAxial(), wall, 1, 1);
  const auto correlation = [](const Image& a, const Image& b, std::size_t offset) {
    const Statistics s = statisticsOf(a);
    double sum = 0.0;
    for (std::size_t i = 0; i + offset < a.size(); ++i) {
      sum += (1e-3 * a[i] - s.mean) * (1e-3 * b[i + offset] - s.mean);
    }
    return sum / static_cast<double>(a.size() - offset) / (s.sigma * s.sigma);
  };
  constexpr double kChance = 0.0075;  // four deviations
  EXPECT_NEAR(correlation(first, first, 0), 1.0, 0.01);
  EXPECT_NEAR(correlation(first, first, 1), 0.0, kChance);
  EXPECT_NEAR(correlation(first, first, kWidth), 0.0, kChance);
  EXPECT_NEAR(correlation(first, second, 0), 0.0, kChance);
}

TEST(KinectNoise, SameSeedAndFrameGiveTheSameImageBitByBit) {
  const Rendering picture = pictureOf(simulatedRoom(1).scene, simulatedRoom(1).path.pose(0.0));
  const Image image = apply({}, picture, 5, 17);
  EXPECT_EQ(apply({}, picture, 5, 17), image);
  EXPECT_NE(apply({}, picture, 5, 18), image);
  EXPECT_NE(apply({}, picture, 6, 17), image);
}

// Pinned, so that a change of compiler, flags or library that alters the noise does not go unseen.
TEST(KinectNoise, GivesTheSameImageOnEveryMachine) {
  Image mm = apply({}, wallAt(2.0), 1, 0);
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (const std::uint16_t pixel : mm) hash = (hash ^ pixel) * 1099511628211U;
  mm.resize(8);
  EXPECT_EQ(mm, Image({2000, 2000, 2000, 2000, 2000, 2000, 1989, 2012}));
  EXPECT_EQ(hash, 10460310334323585944U);
}

TEST(KinectNoise, NothingSeenIsNoDepth) {
  EXPECT_EQ(missingShare(apply({}, pictureOf(Scene()))), 1.0);
  EXPECT_EQ(missingShare(apply(allOff(), pictureOf(Scene()))), 1.0);
  Rendering empty;
  EXPECT_TRUE(apply({}, empty).empty());
}

TEST(KinectNoise, ManagesASinglePixel) {
  Rendering picture;
  picture.width = picture.height = 1;
  picture.depth = {2.0F};
  picture.labels = {0};
  Image mm(1);
  KinectNoise(allOff()).apply(picture, {500, 500, 0, 0}, 0, mm.data());
  EXPECT_EQ(mm[0], 2000);
}

TEST(KinectNoise, RefusesImpossibleParameters) {
  const auto refuses = [](auto change) {
    KinectNoiseParameters p;
    change(p);
    EXPECT_THROW(KinectNoise{p}, std::invalid_argument);
  };
  refuses([](KinectNoiseParameters& p) { p.axial.floor = -1.0; });
  refuses([](KinectNoiseParameters& p) { p.axial.growth = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](KinectNoiseParameters& p) { p.baseline = 0.0; });
  refuses([](KinectNoiseParameters& p) { p.disparity_step = -0.1; });
  refuses([](KinectNoiseParameters& p) { p.max_range = p.min_range; });
  refuses([](KinectNoiseParameters& p) { p.max_range = 70.0; });
  refuses([](KinectNoiseParameters& p) { p.edge_dropout = 1.1; });
  refuses([](KinectNoiseParameters& p) { p.grazing_start = p.grazing_end; });
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
