// SPDX-License-Identifier: BSD-3-Clause
// Each kernel twice: against the sums and fits of single windows, and against itself compiled without
// vectors, bit by bit.
#include "patch_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "scalar_kernels.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

namespace scalar = ::scalar_twin::line_plane_segmentation;

/// Many crossings in a row, their windows looking at planes with noise, some of them with a step or with
/// holes.
class Crossings {
 public:
  explicit Crossings(Random& random) : count_(random.integer(1, 40)), y_(random.uniform(-0.4, 0.4)) {
    for (WindowSums* sums : {&rows_, &columns_, &twin_rows_, &twin_columns_}) sums->resize(count_);
    pixels_.resize(static_cast<std::size_t>(count_));
    std::vector<InverseDepthPlane> planes(pixels_.size());
    for (InverseDepthPlane& plane : planes) {
      plane = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0.3, 1.5)};
      x_.push_back(static_cast<float>(random.uniform(-0.5, 0.5)));
    }
    for (const bool along_row : {true, false}) {
      const double step = random.chance(0.3) ? 0.05 : 0.0;
      std::vector<float> z, t;
      for (int k = -5; k <= 5; ++k) {
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
          const double x = static_cast<double>(x_[i]) + (along_row ? 0.002 * k : 0.0);
          const double y = y_ + (along_row ? 0.0 : 0.002 * k);
          const double w =
              planes[i].at(x, y) + random.uniform(-0.002, 0.002) + (k > 0 && i % 3 == 0 ? step : 0.0);
          const bool is_hole = random.chance(i % 4 == 0 ? 0.5 : 0.05) || w <= 0.0;
          z.push_back(is_hole ? 0.0F : static_cast<float>(1.0 / w));
          t.push_back(static_cast<float>(along_row ? x : y));
          add(i, z.back(), along_row ? static_cast<double>(t.back()) : static_cast<double>(x_[i]),
              along_row ? y_ : static_cast<double>(t.back()), along_row);
        }
      }
      sumPixels(z.data(), t.data(), 11, count_, lanesOf(along_row ? rows_ : columns_));
      scalar::sumPixels(z.data(), t.data(), 11, count_, lanesOf(along_row ? twin_rows_ : twin_columns_));
    }
  }

  int count_;
  double y_;
  std::vector<float> x_;
  WindowSums rows_, columns_, twin_rows_, twin_columns_;

  struct Pixels {
    RegressionMoments both;
    std::vector<Eigen::Vector2d> row, column;  // (t, w)
  };
  std::vector<Pixels> pixels_;

 private:
  void add(std::size_t i, float z, double x, double y, bool along_row) {
    if (!(z > 0.0F)) return;
    const double w = 1.0 / static_cast<double>(z);
    pixels_[i].both += RegressionMoments{x * x, x * y, y * y, x, y, 1.0, x * w, y * w, w, w * w, 1.0};
    (along_row ? pixels_[i].row : pixels_[i].column).emplace_back(along_row ? x : y, w);
  }
};

template <int kRows>
bool isSame(LaneTable<kRows>& a, LaneTable<kRows>& b, int lanes) {
  return std::memcmp(a.row(0), b.row(0), sizeof(double) * kRows * static_cast<std::size_t>(lanes)) == 0;
}

/// The sum of squared errors to the line through points, the plain way.
double squaredErrorOfLine(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) scatter += (point - mean) * (point - mean).transpose();
  const double slope = scatter(0, 1) / scatter(0, 0);
  double error = 0.0;
  for (const Eigen::Vector2d& point : points)
    error += std::pow(point.y() - mean.y() - slope * (point.x() - mean.x()), 2);
  return error;
}

/// Whether moments are those expected times a weight.
bool areNear(const RegressionMoments& moments, const RegressionMoments& expected, double weight) {
  const auto isNear = [weight](double a, double b) { return std::abs(a - b * weight) < 1e-9 * weight; };
  return isNear(moments.xx, expected.xx) && isNear(moments.xy, expected.xy) &&
         isNear(moments.yy, expected.yy) && isNear(moments.x, expected.x) && isNear(moments.y, expected.y) &&
         isNear(moments.one, expected.one) && isNear(moments.xw, expected.xw) &&
         isNear(moments.yw, expected.yw) && isNear(moments.w, expected.w) &&
         isNear(moments.ww, expected.ww) && moments.pixels == expected.pixels;
}

TEST(PatchKernels, SumsAreThoseOfThePixelsWithADepth) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    Crossings crossings(random);
    ASSERT_TRUE(isSame(crossings.rows_, crossings.twin_rows_, crossings.count_));
    ASSERT_TRUE(isSame(crossings.columns_, crossings.twin_columns_, crossings.count_));
    const WindowLanes row = lanesOf(crossings.rows_);
    for (std::size_t i = 0; i < crossings.pixels_.size(); ++i) {
      double t = 0.0, tt = 0.0, w = 0.0, tw = 0.0, ww = 0.0;
      for (const Eigen::Vector2d& pixel : crossings.pixels_[i].row) {
        t += pixel.x();
        tt += pixel.x() * pixel.x();
        w += pixel.y();
        tw += pixel.x() * pixel.y();
        ww += pixel.y() * pixel.y();
      }
      ASSERT_EQ(row.n[i], static_cast<double>(crossings.pixels_[i].row.size()));
      ASSERT_NEAR(row.t[i], t, 1e-12);
      ASSERT_NEAR(row.tt[i], tt, 1e-12);
      ASSERT_NEAR(row.w[i], w, 1e-12);
      ASSERT_NEAR(row.tw[i], tw, 1e-12);
      ASSERT_NEAR(row.ww[i], ww, 1e-12);
    }
  }
}

TEST(PatchKernels, CrossingsAreLeastSquares) {
  const CrossingBounds bounds{DepthTolerance{NoiseParameters{}, 1.6, 0.004}, 1.2, 7.7};
  int planar = 0, with_a_line = 0, without = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    Crossings crossings(random);
    CrossingFits fits, twin;
    fits.resize(crossings.count_);
    twin.resize(crossings.count_);
    fitCrossings(lanesOf(crossings.rows_), lanesOf(crossings.columns_), crossings.x_.data(), crossings.y_,
                 crossings.count_, bounds, fits);
    scalar::fitCrossings(lanesOf(crossings.rows_), lanesOf(crossings.columns_), crossings.x_.data(),
                         crossings.y_, crossings.count_, bounds, twin);
    ASSERT_TRUE(isSame(fits, twin, crossings.count_));
    for (std::size_t i = 0; i < crossings.pixels_.size(); ++i) {
      const Crossings::Pixels& pixels = crossings.pixels_[i];
      const int lane = static_cast<int>(i);
      if (std::min(pixels.row.size(), pixels.column.size()) < 8) {
        ASSERT_EQ(fits(kFitLines, lane), 0.0);
        ASSERT_EQ(fits(kFitPlanar, lane), 0.0);
        ++none;
        continue;
      }
      InverseDepthPlane plane;
      const double squared_error = pixels.both.fit(plane);
      ASSERT_NEAR(fits(kFitA, lane), plane.a, 1e-7);
      ASSERT_NEAR(fits(kFitB, lane), plane.b, 1e-7);
      ASSERT_NEAR(fits(kFitC, lane), plane.c, 1e-7);
      const double tolerance = bounds.tolerance.at(pixels.both.w / pixels.both.one, plane.inverseDistance());
      const double weight = 1.0 / (tolerance * tolerance);
      ASSERT_NEAR(fits(kFitSquaredError, lane), squared_error * weight, 1e-10 * weight);
      ASSERT_TRUE(areNear(momentsOf(fits, lane), pixels.both, weight));
      const double flat = bounds.flatness * tolerance * tolerance;
      const double row = squaredErrorOfLine(pixels.row) / (flat * static_cast<double>(pixels.row.size()));
      const double column =
          squaredErrorOfLine(pixels.column) / (flat * static_cast<double>(pixels.column.size()));
      const double both = squared_error / (flat * pixels.both.pixels);
      if (std::min({std::abs(row - 1.0), std::abs(column - 1.0), std::abs(both - 1.0)}) < 1e-6) continue;
      ASSERT_EQ(fits(kFitLines, lane), (row < 1.0 ? 1.0 : 0.0) + (column < 1.0 ? 1.0 : 0.0));
      const bool is_planar = row < 1.0 && column < 1.0 && both < 1.0;
      ASSERT_EQ(fits(kFitPlanar, lane), is_planar ? 1.0 : 0.0);
      ++(is_planar ? planar : fits(kFitLines, lane) > 0.0 ? with_a_line : without);
    }
  }
  EXPECT_GT(planar, 500);
  EXPECT_GT(with_a_line, 100);
  EXPECT_GT(without, 10);
  EXPECT_GT(none, 100);
}

TEST(PatchKernels, WindowsThatFixNoPlaneAreNotPlanar) {
  const CrossingBounds bounds{DepthTolerance{NoiseParameters{}, 1.6, 0.004}, 1.2, 0.0};
  WindowSums nothing;
  nothing.resize(3);
  std::fill_n(nothing.row(0), 6 * 3, 0.0);
  CrossingFits fits;
  const auto forget = [&fits] { fits.resize(3), std::fill_n(fits.row(0), 17 * 3, 1.0); };
  const auto expectNone = [&fits] {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(fits(kFitLines, i) + fits(kFitPlanar, i), 0.0);
  };
  forget();
  const std::vector<float> x(3, 0.1F);
  fitCrossings(lanesOf(nothing), lanesOf(nothing), x.data(), 0.2, 3, bounds, fits);
  expectNone();

  // All pixels of a row's window at one ray, as of an image without a focal length.
  const std::vector<float> z(27, 1.0F), t(27, 0.1F);
  WindowSums rows;
  rows.resize(3);
  sumPixels(z.data(), t.data(), 9, 3, lanesOf(rows));
  forget();
  fitCrossings(lanesOf(rows), lanesOf(rows), x.data(), 0.1, 3, bounds, fits);
  expectNone();

  fitCrossings(lanesOf(rows), lanesOf(rows), x.data(), 0.1, 0, bounds, fits);
  sumPixels(nullptr, nullptr, 0, 0, lanesOf(rows));
  sumPixels(nullptr, nullptr, 0, 3, lanesOf(rows));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(lanesOf(rows)[i].n, 0.0);
}

}  // namespace
}  // namespace line_plane_segmentation
