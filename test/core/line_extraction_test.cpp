// SPDX-License-Identifier: BSD-3-Clause
#include "lines/line_extraction.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"
#include "support/synthetic_scan.h"

namespace line_plane_segmentation {
namespace {

const NoiseParameters kNoise;

LineParameters vgaLines() { return paperParameters(640).lines; }

std::vector<LineSegment> segmentsOf(const Scanline& scan, const LineParameters& parameters = vgaLines()) {
  std::vector<LineSegment> segments;
  LineExtractor().extract(scan, kNoise, parameters, segments);
  return segments;
}

Scanline straightScan(int first, int last) {
  return scanOf({}, {pieceThrough({}, 320, 1.0, 0.2, first, last)});
}

void dropPixels(int first, int last, Scanline& scan) {
  scan.points.erase(std::remove_if(scan.points.begin(), scan.points.end(),
                                   [=](const ScanPoint& p) { return p.pixel >= first && p.pixel <= last; }),
                    scan.points.end());
}

/// The room of Figure 2: a wall, a box before it, and a floor that falls away; lines meet or step at known
/// pixels.
struct Room {
  std::vector<ScanPiece> pieces = {
      pieceThrough({}, 150, 1.6, 0.7, 0, 149), pieceThrough({}, 150, 1.6, -0.6, 150, 299),
      pieceThrough({}, 300, 0.9, 0.3, 300, 449), pieceThrough({}, 450, 1.4, -0.9, 450, 639)};
};

TEST(LineExtraction, FindsTheWholeOfAStraightScan) {
  const Scanline scan = straightScan(0, 639);
  const std::vector<LineSegment> segments = segmentsOf(scan);
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].first, 0);
  EXPECT_EQ(segments[0].last, 639);
  EXPECT_EQ(segments[0].points, 640);
  EXPECT_NEAR(segments[0].alpha, 0.2, 1e-9);
}

TEST(LineExtraction, CutsAtCornersAndSteps) {
  const Room room;
  for (const double noise_factor : {0.0, 0.2}) {
    Random random(1);
    Scanline scan = scanOf({}, room.pieces);
    addNoise(kNoise, noise_factor, random, scan);
    const std::vector<LineSegment> segments = segmentsOf(scan);
    ASSERT_EQ(segments.size(), room.pieces.size()) << noise_factor;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      EXPECT_LE(std::abs(segments[i].first - room.pieces[i].first), vgaLines().line_window)
          << noise_factor << ' ' << i;
      EXPECT_LE(std::abs(segments[i].last - room.pieces[i].last), vgaLines().line_window)
          << noise_factor << ' ' << i;
      EXPECT_NEAR(segments[i].alpha, room.pieces[i].alpha, 0.02) << noise_factor << ' ' << i;
      EXPECT_NEAR(segments[i].r, room.pieces[i].r, 0.01) << noise_factor << ' ' << i;
    }
  }
}

TEST(LineExtraction, OfFullNoiseCoversThePiecesAndCrossesNoCorner) {
  const Room room;
  Random random(2);
  int covered = 0;
  constexpr int kScans = 20;
  for (int k = 0; k < kScans; ++k) {
    Scanline scan = scanOf({}, room.pieces);
    addNoise(kNoise, 1.0, random, scan);
    for (const LineSegment& segment : segmentsOf(scan)) {
      covered += segment.points;
      for (const int corner : {150, 300, 450}) {
        EXPECT_FALSE(segment.first < corner - vgaLines().line_window &&
                     segment.last > corner + vgaLines().line_window);
      }
    }
  }
  EXPECT_GT(covered, 0.85 * kScans * 640);
}

TEST(LineExtraction, GoesOnAfterAHole) {
  const int window = vgaLines().line_window;
  Scanline scan = straightScan(0, 299);
  dropPixels(100, 100 + window - 1, scan);  // as many as a window: a hole
  std::vector<LineSegment> segments = segmentsOf(scan);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].first, 0);
  EXPECT_EQ(segments[0].last, 99);
  EXPECT_EQ(segments[1].first, 100 + window);
  EXPECT_EQ(segments[1].last, 299);

  dropPixels(100 + window, 130, scan);  // what is left of the second part still starts a piece of its own
  dropPixels(140, 160, scan);           // 131 to 139 is too short for anything, and ends nothing
  segments = segmentsOf(scan);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[1].first, 161);
}

TEST(LineExtraction, BridgesFewMissingPixels) {
  Scanline scan = straightScan(0, 299);
  dropPixels(100, 100 + vgaLines().line_window - 2, scan);
  dropPixels(200, 202, scan);
  const std::vector<LineSegment> segments = segmentsOf(scan);
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].first, 0);
  EXPECT_EQ(segments[0].last, 299);
  EXPECT_EQ(segments[0].points, 300 - (vgaLines().line_window - 1) - 3);
}

TEST(LineExtraction, DropsSegmentsThatAreTooShort) {
  const int shortest = vgaLines().min_line_points;
  EXPECT_TRUE(segmentsOf(straightScan(100, 100 + shortest - 2)).empty());
  const std::vector<LineSegment> segments = segmentsOf(straightScan(100, 100 + shortest - 1));
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].points, shortest);
}

TEST(LineExtraction, OfNothingIsNothing) {
  EXPECT_TRUE(segmentsOf(Scanline{}).empty());
  EXPECT_TRUE(segmentsOf(straightScan(7, 7)).empty());
  LineParameters parameters = vgaLines();
  parameters.min_line_points = 1;
  for (int points = 1; points < parameters.line_window + 2; ++points) {
    EXPECT_TRUE(segmentsOf(straightScan(1, points), parameters).empty()) << "fewer than three windows";
  }
  EXPECT_EQ(segmentsOf(straightScan(1, parameters.line_window + 2), parameters).size(), 1U);
}

TEST(LineExtraction, TellsTheFitOfEachSegment) {
  Random random(3);
  Scanline scan = scanOf({}, Room{}.pieces);
  addNoise(kNoise, 0.2, random, scan);
  const std::vector<LineSegment> segments = segmentsOf(scan);
  ASSERT_FALSE(segments.empty());
  for (const LineSegment& segment : segments) {
    // Without holes, the points are those of the pixels.
    const LineFit line = fitLine(scan.points.data() + segment.first, segment.points, kNoise, 1.0);
    Eigen::Matrix2d information;
    information << line.information_aa, line.information_ar, line.information_ar, line.information_rr;
    EXPECT_EQ(segment.points, segment.last - segment.first + 1);
    EXPECT_EQ(segment.alpha, line.alpha);
    EXPECT_EQ(segment.r, line.r);
    EXPECT_LT((segment.covariance * information - Eigen::Matrix2d::Identity()).norm(), 1e-6);
  }
}

TEST(LineExtraction, AppendsToWhatAnotherScanlineGave) {
  LineExtractor extractor;
  std::vector<LineSegment> segments(1);
  extractor.extract(straightScan(0, 99), kNoise, vgaLines(), segments);
  extractor.extract(straightScan(50, 199), kNoise, vgaLines(), segments);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[1].last, 99);
  EXPECT_EQ(segments[2].first, 50);
}

TEST(Fidelity, SumsTheDistancesOfThreeAdjacentWindows) {
  Random random(4);
  Scanline scan = straightScan(0, 60);
  addNoise(kNoise, 1.0, random, scan);
  LineParameters parameters = vgaLines();
  parameters.line_noise_factor = 1.7;
  const int windows = 61 - parameters.line_window + 1;
  LineExtractor extractor;
  const std::vector<double>& fidelity = extractor.fidelity(scan.points.data(), 61, kNoise, parameters);
  ASSERT_EQ(fidelity.size(), static_cast<std::size_t>(windows));
  const auto window = [&](int i) {
    return fitLine(scan.points.data() + i, parameters.line_window, kNoise, 1.7);
  };
  for (int i = 0; i < windows; ++i) {
    const int middle = std::clamp(i, 1, windows - 2);  // the first and the last take their neighbour's
    const double expected =
        mahalanobis(window(middle), window(middle - 1)) + mahalanobis(window(middle), window(middle + 1));
    EXPECT_DOUBLE_EQ(fidelity[static_cast<std::size_t>(i)], expected) << i;
  }
}

TEST(Fidelity, OfFewerThanThreeWindowsIsEmpty) {
  const Scanline scan = straightScan(0, 60);
  LineExtractor extractor;
  for (int count = 0; count < vgaLines().line_window + 2; ++count) {
    EXPECT_TRUE(extractor.fidelity(scan.points.data(), count, kNoise, vgaLines()).empty()) << count;
  }
  EXPECT_EQ(extractor.fidelity(scan.points.data(), vgaLines().line_window + 2, kNoise, vgaLines()).size(),
            3U);
}

TEST(LineExtraction, ScansRowsThenColumnsOfAnImage) {
  const CameraIntrinsics camera = kinectCamera(320, 240);
  const Surface surface = surfaceAt(1.5, 0.4, -0.2);
  const DepthImage depth = render(surface, camera, 320, 240);
  std::vector<LineSegment> segments(5);  // what was there goes
  LineExtractor().extract(depth, camera, paperParameters(320), segments);
  ASSERT_EQ(segments.size(), 11U + 15U);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool is_row = i < 11;
    EXPECT_EQ(segments[i].direction, is_row ? ScanDirection::kRow : ScanDirection::kColumn) << i;
    EXPECT_EQ(segments[i].scanline, 20 * static_cast<int>(is_row ? i + 1 : i - 10)) << i;
    EXPECT_EQ(segments[i].first, 0) << i;
    EXPECT_EQ(segments[i].last, is_row ? 319 : 239) << i;
    // In the plane of sight of the scanline the surface is the line n_along Sy + n_across Sx + d = 0.
    const double across = is_row ? (segments[i].scanline - camera.cy) / camera.fy
                                 : (segments[i].scanline - camera.cx) / camera.fx;
    const double n_along = is_row ? surface.normal.x() : surface.normal.y();
    const double n_across =
        (surface.normal.z() + across * (is_row ? surface.normal.y() : surface.normal.x())) /
        std::hypot(across, 1.0);
    EXPECT_NEAR(segments[i].alpha, std::atan2(-n_along, -n_across), 1e-5) << i;
    EXPECT_NEAR(segments[i].r, surface.d / std::hypot(n_along, n_across), 1e-5) << i;
  }
}

TEST(LineExtraction, OfImagesWithoutScanlinesOrDepthIsEmpty) {
  std::vector<LineSegment> segments(5);
  LineExtractor extractor;
  for (const int side : {0, 1, 2, 30}) {
    extractor.extract(blankDepth(side, side), kinectCamera(640, 480), paperParameters(640), segments);
    EXPECT_TRUE(segments.empty()) << side;
  }
  extractor.extract(blankDepth(64, 48), kinectCamera(64, 48), paperParameters(64), segments);
  EXPECT_TRUE(segments.empty());
}

}  // namespace
}  // namespace line_plane_segmentation
