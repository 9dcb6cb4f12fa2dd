// SPDX-License-Identifier: BSD-3-Clause
// The limits of single windows, of merges and of the noise measure, on scanlines made of numbers; the rest
// of line_growing.h is tested in line_growing_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "lines/line_growing.h"
#include "planes/inverse_depth_plane.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr double kRho = 0.5;  // [1/m] inverse depth, 2 m away

Parameters parametersOfNoise() {
  Parameters parameters = adaptiveParameters(640);
  parameters.patches.patch_distance = 1e-5;  // so that the tolerance is that of the noise
  parameters.lines.min_line_points = 1;
  return parameters;
}

/// [1/m] the tolerance of a pixel.
double tolerance() {
  const Parameters parameters = parametersOfNoise();
  return DepthTolerance{parameters.noise, parameters.patches.patch_noise_factor, 0.0}.along(kRho);
}

/// One scanline, window by window.
struct Scan : ScanlineSet {
  explicit Scan(int pixels_per_window) {
    window = pixels_per_window;
    pixels = {0};
  }

  /// Appends a window with `count` valid pixels of inverse depth rho_of(0), rho_of(1), ...
  template <typename RhoOf>
  void add(int count, RhoOf&& rho_of) {
    LineSums s;
    for (int i = 0; i < count; ++i) {
      const double t = 0.002 * (windows * window + i), rho = rho_of(i);
      s = s + LineSums{1.0, t, t * t, rho, t * rho, rho * rho};
    }
    sums.push_back(s);
    ++windows;
  }
  /// Appends windows whose pixels deviate from kRho by `tolerances`.
  void addLevel(double tolerances, int count = 1) {
    for (int k = 0; k < count; ++k) add(window, [&](int) { return kRho + tolerances * tolerance(); });
  }

  const std::vector<GrownSegment>& grow() {
    LineGrower().grow({0.0F}, parametersOfNoise(), *this);
    return segments;
  }
};

TEST(LineGrower, DropsASingleWindowThatIsNotFlat) {
  const auto is_segment = [](double mean_square, int windows) {
    Scan scan(40);
    for (int k = 0; k < windows; ++k)
      scan.add(40,
               [&](int i) { return kRho + (i % 2 == 0 ? 1 : -1) * std::sqrt(mean_square) * tolerance(); });
    return !scan.grow().empty();
  };
  const double bound = parametersOfNoise().patches.patch_flatness;
  EXPECT_TRUE(is_segment(0.95 * bound, 1));
  EXPECT_FALSE(is_segment(1.05 * bound, 1));
  EXPECT_TRUE(is_segment(1.05 * bound, 2)) << "a neighbour continues it";
}

TEST(LineGrower, UsesWindowsOfTwoPixels) {
  const auto segments_with = [](int valid_pixels) {
    Scan scan(5);
    for (int i = 0; i < 10; ++i) scan.add(valid_pixels, [](int) { return kRho; });
    return scan.grow().size();
  };
  EXPECT_EQ(segments_with(2), 1U);
  EXPECT_EQ(segments_with(1), 0U);
}

/// Whether two windows are merged that differ by a step. As one line they have `bounds` times the squared
/// error that is allowed, (20 + pixels) tolerance².
bool areMerged(int pixels, double bounds) {
  const auto with_step = [pixels](double tolerances) {
    Scan scan(pixels);
    scan.addLevel(0.0);
    scan.addLevel(tolerances);
    return scan;
  };
  const Scan unit = with_step(1.0);
  const double added = fitInverseDepthLine(unit.sums[0] + unit.sums[1]).squared_error;
  const double allowed = (20 + pixels) * tolerance() * tolerance();
  return with_step(std::sqrt(bounds * allowed / added)).grow().size() == 1;
}

TEST(LineGrower, MergesWindowsThatAreApartByNoiseOrDistortion) {
  for (const int pixels : {5, 200}) {
    EXPECT_TRUE(areMerged(pixels, 0.8)) << pixels;
    EXPECT_FALSE(areMerged(pixels, 1.25)) << pixels;
  }
}

TEST(LineGrower, ContinuesAfterAHoleOfTwoWindows) {
  const auto segments_with_hole = [](int windows) {
    Scan scan(5);
    scan.addLevel(0.0, 4);
    for (int i = 0; i < windows; ++i) scan.add(0, [](int) { return kRho; });
    scan.addLevel(0.0, 4);
    return scan.grow().size();
  };
  EXPECT_EQ(segments_with_hole(2), 1U);
  EXPECT_EQ(segments_with_hole(3), 2U);
}

// Two windows, one at half of a step, and eight beyond it. Merges of up to an eighth of the bound come first.
// With a quarter all become one line, with a sixteenth the middle window joins the first two.
TEST(LineGrower, MergesWhatIsMostAlikeFirst) {
  Scan scan(10);
  scan.addLevel(0.0, 2);
  scan.addLevel(1.55);
  scan.addLevel(3.1, 8);
  const std::vector<GrownSegment>& segments = scan.grow();
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].last, 1);
  EXPECT_EQ(segments[1].first, 2);
}

/// The variance of alpha of a segment of four pixels that do not lie on a line, or of so many times as many.
double varianceOfFourPixels(int times) {
  LineSums sums;
  for (int i = 0; i < 4 * times; ++i) {
    const double t = 0.002 * (i % 4), rho = kRho + (i % 4 == 1 || i % 4 == 2 ? 1e-3 : -1e-3);
    sums = sums + LineSums{1.0, t, t * t, rho, t * rho, rho * rho};
  }
  ScanlineSet set;
  set.direction = ScanDirection::kRow;
  set.pixels = {0};
  set.window = 4;
  set.windows = 1;
  set.sums = {sums};
  set.segments = {{0, 0, 0, sums, 0.0, 0.0}};
  std::vector<LineSegment> segments;
  describeSegments(blankDepth(4, 1), raysOf(kinectCamera(4, 1), 4, 1), set, segments);
  return segments.at(0).covariance(0, 0);
}

TEST(DescribeSegments, TakesTwoDegreesOfFreedom) {
  EXPECT_NEAR(varianceOfFourPixels(1) / varianceOfFourPixels(2), (8.0 - 2.0) / (4.0 - 2.0), 1e-6);
}

constexpr int kWindow = 5;

/// A scanline of pieces, each at a random distance from the line. The pixels of a piece share their error,
/// whose variance is that of the model.
Scan noisyPieces(int pieces, int windows_per_piece) {
  // The distance of a piece from the line through its neighbours has 1.5 times the variance of a piece.
  const double sigma = std::sqrt(1.0 / 1.5) * NoiseParameters{}.sigma(1.0 / kRho) * kRho * kRho;
  Random random(2);
  Scan scan(kWindow);
  for (int piece = 0; piece < pieces; ++piece) {
    const double rho = kRho + sigma * random.gaussian();
    for (int i = 0; i < windows_per_piece; ++i) scan.add(kWindow, [rho](int) { return rho; });
  }
  return scan;
}

TEST(NoiseMeter, MeasuresOneForAKinectsNoise) {
  EXPECT_NEAR(NoiseMeter().ratio(noisyPieces(8000, 2), Scan(kWindow), {}), 1.0, 0.05);
}

TEST(NoiseMeter, MeasuresDistortionInPiecesOfTheGivenLength) {
  // To the nearest window, at least two windows.
  for (const double length : {5.6, 6.4})
    EXPECT_NEAR(NoiseMeter().distortionRatio(noisyPieces(8000, 6), Scan(kWindow), {}, length * kWindow), 1.0,
                0.05);
  EXPECT_NEAR(NoiseMeter().distortionRatio(noisyPieces(8000, 2), Scan(kWindow), {}, kWindow), 1.0, 0.05);
}

/// The measured noise of pieces of two windows that have `valid_pixels` each.
double ratioOfPieces(int pieces, int valid_pixels) {
  Scan scan(10);
  for (int i = 0; i < 2 * (pieces + 2); ++i)
    scan.add(valid_pixels, [&](int) { return kRho + (i / 2 % 2 == 0 ? 2.0 : -2.0) * tolerance(); });
  return NoiseMeter().ratio(scan, Scan(10), {});
}

TEST(NoiseMeter, MeasuresIn20PiecesOrMore) {
  EXPECT_GT(ratioOfPieces(20, 10), 3.0);
  EXPECT_EQ(ratioOfPieces(19, 10), 1.0);
}

TEST(NoiseMeter, MeasuresInPiecesWith70PercentOfThePixels) {
  EXPECT_GT(ratioOfPieces(100, 8), 3.0);
  EXPECT_EQ(ratioOfPieces(100, 6), 1.0);
}

}  // namespace
}  // namespace line_plane_segmentation
