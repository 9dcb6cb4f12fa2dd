// SPDX-License-Identifier: BSD-3-Clause
// The fit of one line; how lines become segments is in line_extraction_test.cpp.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "lines/line_extraction.h"
#include "support/random.h"
#include "support/synthetic_scan.h"

namespace line_plane_segmentation {
namespace {

constexpr double kPi = 3.14159265358979323846;
const NoiseParameters kNoise;

LineFit fit(const std::vector<ScanPoint>& points, double noise_factor = 1.0) {
  return fitLine(points.data(), static_cast<int>(points.size()), kNoise, noise_factor);
}

Eigen::Matrix2d informationOf(const LineFit& line) {
  Eigen::Matrix2d information;
  information << line.information_aa, line.information_ar, line.information_ar, line.information_rr;
  return information;
}

double turn(double from, double to) { return std::remainder(to - from, 2.0 * kPi); }

/// Sum of the squared distances to the best of all lines of that direction.
double costOf(const std::vector<ScanPoint>& points, double alpha) {
  double mean = 0.0, cost = 0.0;
  for (const ScanPoint& p : points)
    mean += (p.x * std::cos(alpha) + p.y * std::sin(alpha)) / static_cast<double>(points.size());
  for (const ScanPoint& p : points) cost += std::pow(p.x * std::cos(alpha) + p.y * std::sin(alpha) - mean, 2);
  return cost;
}

/// The direction in [0, pi) of least cost, by trying them all, ever more finely.
double bruteForceDirection(const std::vector<ScanPoint>& points) {
  double best = 0.0;
  for (double width = 0.5 * kPi, centre = 0.5 * kPi; width > 1e-7; width *= 0.05) {
    best = centre;
    for (double alpha = centre - width; alpha <= centre + width; alpha += 0.01 * width) {
      if (costOf(points, alpha) < costOf(points, best)) best = alpha;
    }
    centre = best;
  }
  return best;
}

std::vector<ScanPoint> randomPiece(Random& random) {
  const int first = random.integer(0, 400), count = random.integer(2, 60);
  const ScanPiece piece =
      pieceThrough({}, first, random.uniform(0.5, 4.0), random.uniform(-1.2, 1.2), first, first + count - 1);
  Scanline scan = scanOf({}, {piece});
  addNoise(kNoise, random.uniform(0.0, 0.5), random, scan);
  return scan.points;
}

TEST(FitLine, IsTheBestOfAllLines) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<ScanPoint> points = randomPiece(random);
    const LineFit line = fit(points);
    const double best = bruteForceDirection(points);
    EXPECT_NEAR(std::remainder(line.alpha - best, kPi), 0.0, 1e-5);
    double r = 0.0;
    for (const ScanPoint& p : points)
      r += (p.x * std::cos(line.alpha) + p.y * std::sin(line.alpha)) / static_cast<double>(points.size());
    EXPECT_NEAR(line.r, r, 1e-12);
  }
}

TEST(FitLine, FindsAnExactLine) {
  for (const double alpha : {-1.0, -0.3, 0.0, 0.5, 1.2}) {
    const ScanPiece piece = pieceThrough({}, 300, 2.0, alpha, 280, 320);
    const LineFit line = fit(scanOf({}, {piece}).points);
    EXPECT_NEAR(line.alpha, piece.alpha, 1e-9);
    EXPECT_NEAR(line.r, piece.r, 1e-9);
  }
}

TEST(FitLine, GivesAPositiveDistanceInWhicheverDirection) {
  for (double alpha = -3.1; alpha < 3.14; alpha += 0.1) {
    std::vector<ScanPoint> points;
    for (int i = 0; i < 9; ++i) {
      const double t = 0.1 * i - 0.2;
      points.push_back(
          {i, 0.7 * std::cos(alpha) - t * std::sin(alpha), 0.7 * std::sin(alpha) + t * std::cos(alpha), 1.0});
    }
    const LineFit line = fit(points);
    EXPECT_NEAR(line.r, 0.7, 1e-12);
    EXPECT_NEAR(turn(line.alpha, alpha), 0.0, 1e-9) << alpha;
    EXPECT_LE(std::abs(line.alpha), kPi);
    EXPECT_NEAR(-line.information_ar / line.information_rr, 0.2, 1e-9)
        << "where along the line the points are";
  }
}

TEST(FitLine, HasTheCovarianceOfRepeatedNoise) {
  Random random(2);
  const struct {
    double z, alpha;
    int points;
  } cases[] = {{0.8, 0.0, 60}, {1.2, 0.6, 80}, {1.6, -0.8, 80}, {2.5, 0.3, 120}};
  for (const auto& c : cases) {
    const ScanPiece piece = pieceThrough({}, 380, c.z, c.alpha, 380 - c.points / 2, 380 + c.points / 2);
    const Scanline exact = scanOf({}, {piece});
    const LineFit truth = fit(exact.points);
    constexpr int kTrials = 10000;
    Eigen::Matrix2d sampled = Eigen::Matrix2d::Zero();
    for (int trial = 0; trial < kTrials; ++trial) {
      Scanline noisy = exact;
      addNoise(kNoise, 1.0, random, noisy);
      const LineFit line = fit(noisy.points);
      const Eigen::Vector2d difference(turn(truth.alpha, line.alpha), line.r - truth.r);
      sampled += difference * difference.transpose() / kTrials;
    }
    // Were they equal, the one would make the other the identity.
    const Eigen::Matrix2d root = Eigen::LLT<Eigen::Matrix2d>(informationOf(truth)).matrixU();
    const Eigen::Matrix2d ratio = root * sampled * root.transpose();
    const Eigen::Vector2d eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(ratio).eigenvalues();
    EXPECT_GT(eigenvalues[0], 0.85) << c.z;
    EXPECT_LT(eigenvalues[1], 1.15) << c.z;
  }
}

TEST(FitLine, TakesTheNoiseFactorAsAStandardDeviation) {
  const Scanline scan = scanOf({}, {pieceThrough({}, 300, 2.0, 0.4, 280, 320)});
  const Eigen::Matrix2d once = informationOf(fit(scan.points, 1.0)),
                        thrice = informationOf(fit(scan.points, 3.0));
  EXPECT_LT((once - 9.0 * thrice).norm(), 1e-9 * once.norm());
}

TEST(FitLine, StaysFiniteForALineThroughTheCamera) {
  std::vector<ScanPoint> points;
  for (int i = 0; i < 12; ++i) points.push_back({i, 1.0 + 0.1 * i, 0.0, 1.0 + 0.1 * i});
  const LineFit line = fit(points);
  EXPECT_NEAR(line.r, 0.0, 1e-12);
  EXPECT_TRUE(informationOf(line).allFinite());
}

/// The points turned about their middle by `angle` and moved across their line by `offset` [m].
std::vector<ScanPoint> displaced(std::vector<ScanPoint> points, double angle, double offset) {
  const LineFit line = fit(points);
  double x_mean = 0.0, y_mean = 0.0;
  for (const ScanPoint& p : points) {
    x_mean += p.x / static_cast<double>(points.size());
    y_mean += p.y / static_cast<double>(points.size());
  }
  for (ScanPoint& p : points) {
    const double x = p.x - x_mean, y = p.y - y_mean;
    p.x = x_mean + x * std::cos(angle) - y * std::sin(angle) + offset * std::cos(line.alpha + angle);
    p.y = y_mean + x * std::sin(angle) + y * std::cos(angle) + offset * std::sin(line.alpha + angle);
  }
  return points;
}

TEST(Mahalanobis, IsTheDefinitionForNearLines) {
  const Scanline scan = scanOf({}, {pieceThrough({}, 300, 1.5, 0.4, 290, 310)});
  const LineFit line = fit(scan.points);
  EXPECT_EQ(mahalanobis(line, line), 0.0);
  for (const double angle : {-1e-6, 0.0, 1e-6}) {
    for (const double offset : {-1e-6, 1e-6}) {
      const LineFit other = fit(displaced(scan.points, angle, offset));
      const Eigen::Vector2d difference(turn(line.alpha, other.alpha), other.r - line.r);
      const double expected = difference.dot(informationOf(line) * difference);
      EXPECT_NEAR(mahalanobis(line, other), expected, 1e-3 * expected);
    }
  }
}

// About the camera, (alpha, r) bends: a turn by 0.1 rad, which is one standard deviation for a window of 11
// points, moves the r of a line 1 m away by 5 mm beyond its linear covariance.
TEST(Mahalanobis, MeasuresTurnsAsLargeAsNoiseMakesThem) {
  const Scanline scan = scanOf({}, {pieceThrough({}, 350, 1.0, 0.3, 345, 355)});
  const LineFit line = fit(scan.points);
  const Eigen::Matrix2d covariance = informationOf(line).inverse();
  // About their own middle, turn and offset are independent; r's variance there is what alpha does not
  // explain.
  const double variance_alpha = covariance(0, 0);
  const double variance_offset = 1.0 / line.information_rr;
  for (const double angle : {-0.2, -0.05, 0.0, 0.1}) {
    for (const double offset : {-0.003, 0.0, 0.01}) {
      const double expected = angle * angle / variance_alpha + offset * offset / variance_offset;
      EXPECT_NEAR(mahalanobis(line, fit(displaced(scan.points, angle, offset))), expected,
                  1e-6 * (1.0 + expected));
    }
  }
}

TEST(Mahalanobis, FollowsTheChiSquaredLaw) {
  Random random(3);
  const Scanline exact = scanOf({}, {pieceThrough({}, 330, 1.2, 0.3, 300, 360)});
  const LineFit truth = fit(exact.points);
  constexpr int kTrials = 5000;
  double mean = 0.0, below_95 = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Scanline noisy = exact;
    addNoise(kNoise, 1.0, random, noisy);
    const double distance = mahalanobis(truth, fit(noisy.points));
    mean += distance / kTrials;
    below_95 += distance < 5.99 ? 1.0 / kTrials : 0.0;
  }
  EXPECT_NEAR(mean, 2.0, 0.15);
  EXPECT_NEAR(below_95, 0.95, 0.015);
}

TEST(Mahalanobis, TakesTheShortWayRound) {
  LineFit line;
  line.alpha = 3.1;
  line.r = 1.0;
  line.information_aa = 100.0;
  line.information_rr = 100.0;
  LineFit beyond = line, across = line;
  beyond.alpha = 3.2;
  across.alpha = 3.2 - 2.0 * kPi;
  EXPECT_NEAR(mahalanobis(line, across), mahalanobis(line, beyond), 1e-9);
  EXPECT_NEAR(mahalanobis(across, line), mahalanobis(beyond, line), 1e-9);
}

// Seen edge-on, the depth's noise moves points along the line. Across it, the width of the pixels remains.
TEST(FitLine, HasErrorsOfAtLeastATwentiethOfTheDepthsNoise) {
  constexpr int kPoints = 20;
  const auto error_at = [](double facing) {
    std::vector<ScanPoint> points;
    for (int i = 0; i < kPoints; ++i) points.push_back({i, 2.0 * facing, 0.01 * i, 2.0});
    return 1.0 / std::sqrt(fit(points).information_rr / kPoints) / kNoise.sigma(2.0);
  };
  EXPECT_NEAR(error_at(0.08), 0.08, 1e-6);
  EXPECT_NEAR(error_at(0.03), 0.05, 1e-6);
}

}  // namespace
}  // namespace line_plane_segmentation
