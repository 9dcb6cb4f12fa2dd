// SPDX-License-Identifier: BSD-3-Clause
// The line segments grown from windows of scanlines, and the noise measured in these.
#include "lines/line_growing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);
const ViewRays kRays = raysOf(kCamera, kWidth, kHeight);

/// The scanlines of an image and their segments.
struct Lines {
  ScanlineSet rows, columns;
  Parameters parameters = adaptiveParameters(kWidth);
  DepthImage depth;

  explicit Lines(const DepthImage& image, int min_line_points = 0) : depth(image) {
    if (min_line_points > 0) parameters.lines.min_line_points = min_line_points;
    const ViewRays rays = raysOf(kinectCamera(depth.width, depth.height), depth.width, depth.height);
    WindowSummer().sum(depth, rays, parameters.scanlines.scanline_spacing, parameters.lines.line_window, rows,
                       columns);
    LineGrower grower;
    grower.grow(rays.y, parameters, rows);
    grower.grow(rays.x, parameters, columns);
  }

  std::vector<LineSegment> described() const {
    std::vector<LineSegment> segments;
    describeSegments(depth, kRays, rows, segments);
    describeSegments(depth, kRays, columns, segments);
    return segments;
  }

  /// The segments of the row nearest to the middle of the image.
  std::vector<GrownSegment> ofMiddleRow() const {
    std::vector<GrownSegment> segments;
    for (const GrownSegment& segment : rows.segments) {
      if (segment.scanline == rows.count() / 2) segments.push_back(segment);
    }
    return segments;
  }
};

DepthImage noisy(DepthImage depth, double factor, std::uint64_t seed = 3) {
  Random random(seed);
  addNoise({}, factor, random, depth);
  return depth;
}

TEST(LineGrower, GrowsOneSegmentPerScanlineOfAPlane) {
  const Lines lines(noisy(render(surfaceAt(2.0, 0.5, -0.3), kCamera, kWidth, kHeight), 1.0));
  EXPECT_EQ(lines.rows.segments.size(), static_cast<std::size_t>(lines.rows.count()));
  EXPECT_EQ(lines.columns.segments.size(), static_cast<std::size_t>(lines.columns.count()));
  for (const GrownSegment& segment : lines.rows.segments) {
    EXPECT_EQ(segment.first, 0);
    EXPECT_EQ(segment.last, lines.rows.windows - 1);
  }
}

TEST(LineGrower, SplitsAtAStepAndAtACrease) {
  for (const DepthImage& depth :
       {halves(surfaceAt(1.4), surfaceAt(1.5), kCamera, kWidth, kHeight),
        halves(surfaceAt(1.8, 0.4), surfaceAt(1.8, -0.4), kCamera, kWidth, kHeight)}) {
    const Lines lines(noisy(depth, 0.5));
    const std::vector<GrownSegment> segments = lines.ofMiddleRow();
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_NEAR(segments[0].last * lines.rows.window, 160, 10);
    EXPECT_NEAR(segments[1].first * lines.rows.window, 160, 10);
  }
}

// Wherever the step lies in a window: such a window is steep, and steep surfaces have large tolerances.
TEST(LineGrower, HasNoSegmentAcrossAStep) {
  const int window = adaptiveParameters(kWidth).lines.line_window;
  for (int edge = 160; edge < 160 + window; ++edge) {
    DepthImage depth = render(surfaceAt(2.4), kCamera, kWidth, kHeight);
    paint(surfaceAt(1.3), kCamera, {edge, kWidth, 0, kHeight}, depth);
    const Lines lines(depth);
    const std::vector<GrownSegment> segments = lines.ofMiddleRow();
    ASSERT_EQ(segments.size(), 2U) << edge;
    EXPECT_LE((segments[0].last + 1) * lines.rows.window, edge);
    EXPECT_GE(segments[1].first * lines.rows.window, edge);
  }
}

TEST(LineGrower, ContinuesAfterASmallHoleOnly) {
  DepthImage depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
  paint(surfaceAt(2.0), kCamera, {0, 0, 0, 0}, depth);
  const auto with_hole = [&depth](int pixels) {
    DepthImage holey = depth;
    for (int v = 0; v < kHeight; ++v) std::fill_n(holey.row(v) + 150, pixels, 0.0F);
    return Lines(holey).ofMiddleRow().size();
  };
  EXPECT_EQ(with_hole(10), 1U);
  EXPECT_EQ(with_hole(40), 2U);
}

TEST(LineGrower, DropsSegmentsOfTooFewPoints) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.5), kCamera, {100, 130, 0, kHeight}, depth);
  EXPECT_EQ(Lines(depth, 30).ofMiddleRow().size(), 1U);
  EXPECT_EQ(Lines(depth, 31).ofMiddleRow().size(), 0U);
}

// What lineSegments() shows, to the pixel, in an image with holes.
TEST(DescribeSegments, CountsThePointsBetweenTheEnds) {
  const Surface wall = surfaceAt(1.7, 0.4, 0.2);
  DepthImage depth = render(wall, kCamera, kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 3; u < kWidth; u += 5) depth.row(v)[u] = 0.0F;
  }
  const std::vector<LineSegment> segments = Lines(depth).described();
  ASSERT_FALSE(segments.empty());
  for (const LineSegment& segment : segments) {
    const bool is_row = segment.direction == ScanDirection::kRow;
    const auto is_valid = [&](int i) {
      return (is_row ? depth.at(i, segment.scanline) : depth.at(segment.scanline, i)) > 0.0F;
    };
    ASSERT_TRUE(is_valid(segment.first) && is_valid(segment.last));
    int points = 0;
    for (int i = segment.first; i <= segment.last; ++i) points += is_valid(i) ? 1 : 0;
    EXPECT_EQ(segment.points, points);
    EXPECT_GT(segment.covariance.trace(), 0.0);

    // Points of the segment lie on its polar form (Eq. 1-3).
    const double across =
        static_cast<double>((is_row ? kRays.y : kRays.x)[static_cast<std::size_t>(segment.scanline)]);
    const double k = std::sqrt(across * across + 1.0);
    for (const int i : {segment.first, segment.last}) {
      const double z =
          static_cast<double>(is_row ? depth.at(i, segment.scanline) : depth.at(segment.scanline, i));
      const double along = static_cast<double>((is_row ? kRays.x : kRays.y)[static_cast<std::size_t>(i)]);
      EXPECT_NEAR(k * z * std::cos(segment.alpha) + along * z * std::sin(segment.alpha), segment.r, 1e-4);
    }
  }
}

TEST(DescribeSegments, HasTheCovarianceThatRepeatedNoiseGives) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero(), predicted = Eigen::Matrix2d::Zero();
  constexpr int kTrials = 300;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    const Lines lines(noisy(render(surfaceAt(1.6, 0.3), kCamera, kWidth, 20), 1.0, 100 + trial));
    const std::vector<LineSegment> segments = lines.described();
    const LineSegment& segment = segments.front();
    ASSERT_EQ(segment.points, kWidth);
    const Eigen::Vector2d polar(segment.alpha, segment.r);
    sum += polar;
    squares += polar * polar.transpose();
    predicted += segment.covariance;
  }
  const Eigen::Matrix2d sampled = squares - sum * sum.transpose() / kTrials;
  for (const int i : {0, 1}) EXPECT_NEAR(sampled(i, i) / predicted(i, i), 1.0, 0.3) << i;
}

double ratioOf(const DepthImage& depth) {
  const Lines lines(depth);
  return NoiseMeter().ratio(lines.rows, lines.columns, NoiseParameters{});
}

TEST(NoiseMeter, GrowsInProportionToTheNoise) {
  const DepthImage clean = render(surfaceAt(2.0, 0.3), kCamera, kWidth, kHeight);
  const double once = ratioOf(noisy(clean, 1.0));
  EXPECT_GT(once, 0.2);
  EXPECT_NEAR(ratioOf(noisy(clean, 3.0)) / once, 3.0, 0.3);
  EXPECT_LT(ratioOf(clean), 0.1);
}

double distortionOf(const DepthImage& depth) {
  const Lines lines(depth);
  return NoiseMeter().distortionRatio(lines.rows, lines.columns, NoiseParameters{}, 30.0);
}

TEST(NoiseMeter, SeesDistortionOverSeveralScanlines) {
  const DepthImage clean = render(surfaceAt(2.0, 0.3), kCamera, kWidth, kHeight);
  const DepthImage noise = noisy(clean, 1.0);
  EXPECT_LT(distortionOf(noise), ratioOf(noise));
  DepthImage wavy = noise;  // by 5 mm, 192 pixels from crest to crest
  for (std::size_t i = 0; i < wavy.z.size(); ++i) {
    const std::size_t width = static_cast<std::size_t>(kWidth);
    const double phase = 2.0 * 3.14159 / 192.0;
    const double u = static_cast<double>(i % width), v = static_cast<double>(i / width);
    wavy.z[i] += static_cast<float>(0.005 * (std::sin(phase * u) + std::sin(phase * v)));
  }
  EXPECT_NEAR(ratioOf(wavy), ratioOf(noise), 0.1);
  EXPECT_GT(distortionOf(wavy), 1.5 * distortionOf(noise));
}

TEST(NoiseMeter, IsOneWithoutEnoughPixels) {
  EXPECT_EQ(ratioOf(blankDepth(kWidth, kHeight)), 1.0);
  EXPECT_EQ(distortionOf(blankDepth(kWidth, kHeight)), 1.0);
}

TEST(LineGrower, OfNothingIsNothing) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 50}, {50, 1}, {3, 3}}) {
    const Lines lines(blankDepth(width, height));
    EXPECT_TRUE(lines.rows.segments.empty());
    EXPECT_TRUE(lines.columns.segments.empty());
  }
}

}  // namespace
}  // namespace line_plane_segmentation
