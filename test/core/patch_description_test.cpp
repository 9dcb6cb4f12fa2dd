// SPDX-License-Identifier: BSD-3-Clause
// Patches as line segments and candidates, for whoever wants to see them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "line_plane_segmentation/surface_patch.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

PatchGrid detect(const DepthImage& depth, const ViewRays& rays, const Parameters& parameters) {
  PatchGrid grid;
  PatchDetector().detect(depth, rays, parameters, grid);
  return grid;
}

TEST(DescribePatches, ShowsAPlaneAsLinesAlongItsScanlines) {
  const CameraIntrinsics camera = kinectCamera(320, 240);
  const ViewRays rays = raysOf(camera, 320, 240);
  const Surface surface = surfaceAt(1.5, 0.4, -0.2);
  const Parameters parameters = adaptiveParameters(320);
  const PatchGrid grid = detect(render(surface, camera, 320, 240), rays, parameters);
  std::vector<LineSegment> segments(3);
  std::vector<PlaneCandidate> candidates(3);  // what was there goes
  describePatches(grid, rays, parameters, segments, candidates);
  ASSERT_EQ(candidates.size(), grid.patches.size());
  for (const PlaneCandidate& candidate : candidates) {
    EXPECT_LT((candidate.normal - surface.normal).norm(), 1e-4);
    EXPECT_NEAR(candidate.d, surface.d, 1e-4);
  }
  EXPECT_EQ(segments.size(), static_cast<std::size_t>(grid.columns + grid.rows));
  for (const LineSegment& segment : segments) {
    const bool is_row = segment.direction == ScanDirection::kRow;
    // As the paper's lines, Eq. 1-3: see line_extraction_test.cpp.
    const double across = is_row ? rays.y[static_cast<std::size_t>(segment.scanline)]
                                 : rays.x[static_cast<std::size_t>(segment.scanline)];
    const double n_along = is_row ? surface.normal.x() : surface.normal.y();
    const double n_across =
        (surface.normal.z() + across * (is_row ? surface.normal.y() : surface.normal.x())) /
        std::hypot(across, 1.0);
    EXPECT_NEAR(segment.alpha, std::atan2(-n_along, -n_across), 1e-4);
    EXPECT_NEAR(segment.r, surface.d / std::hypot(n_along, n_across), 1e-4);
    EXPECT_GE(segment.first, 0);
    EXPECT_LT(segment.last, is_row ? 320 : 240);
    EXPECT_GT(segment.points, (is_row ? 320 : 240) * 8 / 10);
  }
}

// A segment of many patches is where all of them are, not where the last one points.
TEST(DescribePatches, LongSegmentsStayOnANoisySurface) {
  const CameraIntrinsics camera = kinectCamera(640, 480);
  const ViewRays rays = raysOf(camera, 640, 480);
  const Surface surface = surfaceAt(2.0, 0.3, 0.2);
  const Parameters parameters = adaptiveParameters(640);
  DepthImage depth = render(surface, camera, 640, 480);
  Random random(3);
  addNoise(parameters.noise, 1.0, random, depth);
  std::vector<LineSegment> segments;
  std::vector<PlaneCandidate> candidates;
  describePatches(detect(depth, rays, parameters), rays, parameters, segments, candidates);
  int tested = 0;
  for (const LineSegment& segment : segments) {
    const bool is_row = segment.direction == ScanDirection::kRow;
    const auto scanline = static_cast<std::size_t>(segment.scanline);
    if (segment.points < 100) continue;
    ++tested;
    for (const int pixel : {segment.first, segment.last}) {
      const auto place = static_cast<std::size_t>(pixel);
      const double x = rays.x[is_row ? place : scanline];
      const double y = rays.y[is_row ? scanline : place];
      const double along = is_row ? x : y, k = std::hypot(is_row ? y : x, 1.0);
      const double z = segment.r / (k * std::cos(segment.alpha) + along * std::sin(segment.alpha));
      const double expected = surface.depthAlong(x, y);
      EXPECT_NEAR(z, expected, 4.0 * parameters.noise.sigma(expected)) << segment.points;
    }
  }
  EXPECT_GT(tested, 20);
}

TEST(DescribePatches, SegmentsEndAtAnEdge) {
  CameraIntrinsics camera = kinectCamera(640, 480);
  camera.cx = 324.0;  // half way between two patches
  const ViewRays rays = raysOf(camera, 640, 480);
  const Parameters parameters = adaptiveParameters(640);
  // They meet there, at a right angle.
  DepthImage depth = render(surfaceAt(2.0, 0.8), camera, 640, 480);
  paint(surfaceAt(2.0, 0.8 - M_PI / 2), camera, {324, 640, 0, 480}, depth);
  std::vector<LineSegment> segments;
  std::vector<PlaneCandidate> candidates;
  describePatches(detect(depth, rays, parameters), rays, parameters, segments, candidates);
  int rows = 0;
  for (const LineSegment& segment : segments) {
    if (segment.direction != ScanDirection::kRow) continue;
    ++rows;
    EXPECT_FALSE(segment.first < 310 && segment.last > 338) << segment.first << " to " << segment.last;
    EXPECT_GT(segment.points, 200);
  }
  EXPECT_EQ(rows, 2 * 40);
}

TEST(DescribePatches, OfNothingIsNothing) {
  std::vector<LineSegment> segments(3);
  std::vector<PlaneCandidate> candidates(3);
  describePatches(PatchGrid{}, ViewRays{}, adaptiveParameters(320), segments, candidates);
  EXPECT_TRUE(segments.empty());
  EXPECT_TRUE(candidates.empty());
}

}  // namespace
}  // namespace line_plane_segmentation
