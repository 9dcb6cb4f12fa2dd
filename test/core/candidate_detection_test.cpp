// SPDX-License-Identifier: BSD-3-Clause
#include "planes/candidate_detection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/principal_axes.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 64, kHeight = 48;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);
const ViewRays kRays = raysOf(kCamera, kWidth, kHeight);

/// Accepts every window that has a plane.
CandidateParameters anyPlane() {
  CandidateParameters p;
  p.normal_window = 6;
  p.min_window_points = 3;
  p.max_curvature = 1.0;
  return p;
}

LineSegment segmentAt(ScanDirection direction, int scanline, int first, int last) {
  LineSegment segment;
  segment.direction = direction;
  segment.scanline = scanline;
  segment.first = first;
  segment.last = last;
  return segment;
}

std::vector<PlaneCandidate> detect(const DepthImage& depth, const std::vector<LineSegment>& segments,
                                   const CandidateParameters& parameters) {
  std::vector<PlaneCandidate> candidates(3);  // what was there goes
  detectCandidates(depth, kRays, segments, parameters, candidates);
  return candidates;
}

/// The window's points, straight from the definition: `side` pixels each way, the middle one at side / 2.
std::vector<Eigen::Vector3d> pointsAround(const DepthImage& depth, int u, int v, int side) {
  std::vector<Eigen::Vector3d> points;
  for (int j = v - side / 2; j < v - side / 2 + side; ++j) {
    for (int i = u - side / 2; i < u - side / 2 + side; ++i) {
      if (i < 0 || i >= depth.width || j < 0 || j >= depth.height || !(depth.at(i, j) > 0.0F)) continue;
      points.push_back(pointAt(depth, kRays, i, j));
    }
  }
  return points;
}

TEST(CandidateDetection, IsThePrincipalPlaneOfTheWindow) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const DepthImage depth = randomScene(100 + seed, kWidth, kHeight);
    CandidateParameters parameters = anyPlane();
    parameters.normal_window = random.integer(3, 20);
    std::vector<LineSegment> segments;
    for (int i = 0; i < 20; ++i) {
      const int u = random.integer(0, kWidth - 1), v = random.integer(0, kHeight - 1);
      segments.push_back(segmentAt(ScanDirection::kRow, v, u, u));
      segments.push_back(segmentAt(ScanDirection::kColumn, u, v, v));
    }
    const std::vector<PlaneCandidate> candidates = detect(depth, segments, parameters);
    for (const PlaneCandidate& candidate : candidates) {
      const PrincipalAxes axes =
          principalAxesOf(pointsAround(depth, candidate.u, candidate.v, parameters.normal_window));
      EXPECT_NEAR(candidate.curvature, axes.curvature(), 1e-9);
      EXPECT_NEAR(std::abs(candidate.normal.dot(axes.normal)), 1.0, 1e-7);
      EXPECT_NEAR(candidate.normal.dot(axes.centroid) + candidate.d, 0.0, 1e-9);
      EXPECT_GE(candidate.d, 0.0);
    }
  }
}

TEST(CandidateDetection, LiesInTheMiddlesOfEqualParts) {
  const DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  const struct {
    int points;
    std::vector<int> positions;  // along the segment from 10 to 40
  } cases[] = {{1, {25}}, {3, {15, 25, 35}}, {5, {13, 19, 25, 31, 37}}};
  for (const auto& c : cases) {
    CandidateParameters parameters = anyPlane();
    parameters.points_per_segment = c.points;
    const std::vector<PlaneCandidate> in_row =
        detect(depth, {segmentAt(ScanDirection::kRow, 12, 10, 40)}, parameters);
    const std::vector<PlaneCandidate> in_column =
        detect(depth, {segmentAt(ScanDirection::kColumn, 12, 10, 40)}, parameters);
    ASSERT_EQ(in_row.size(), c.positions.size());
    ASSERT_EQ(in_column.size(), c.positions.size());
    for (std::size_t i = 0; i < c.positions.size(); ++i) {
      EXPECT_EQ(in_row[i].u, c.positions[i]);
      EXPECT_EQ(in_row[i].v, 12);
      EXPECT_EQ(in_column[i].u, 12);
      EXPECT_EQ(in_column[i].v, c.positions[i]);
    }
  }
}

TEST(CandidateDetection, MovesOffAHoleToAValidPixel) {
  DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  for (int u = 22; u <= 27; ++u) depth.row(12)[u] = 0.0F;
  for (int v = 22; v <= 27; ++v) depth.row(v)[30] = 0.0F;
  const std::vector<PlaneCandidate> candidates = detect(
      depth, {segmentAt(ScanDirection::kRow, 12, 10, 40), segmentAt(ScanDirection::kColumn, 30, 10, 40)},
      anyPlane());
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_EQ(candidates[0].u, 21);
  EXPECT_EQ(candidates[0].v, 12);
  EXPECT_EQ(candidates[1].u, 30);
  EXPECT_EQ(candidates[1].v, 21);
}

TEST(CandidateDetection, NeedsPointsEnoughInTheWindow) {
  DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  depth.row(22)[23] = 0.0F;  // 35 of the 36 around (25, 25) are left
  const std::vector<LineSegment> segment = {segmentAt(ScanDirection::kRow, 25, 10, 40)};
  CandidateParameters parameters = anyPlane();
  parameters.min_window_points = 35;
  EXPECT_EQ(detect(depth, segment, parameters).size(), 1U);
  parameters.min_window_points = 36;
  EXPECT_TRUE(detect(depth, segment, parameters).empty());
}

TEST(CandidateDetection, DropsWhatIsNotFlatEnough) {
  Random random(5);
  DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  addNoise({}, 3.0, random, depth);
  const std::vector<LineSegment> segment = {segmentAt(ScanDirection::kRow, 25, 10, 40)};
  const double curvature = principalAxesOf(pointsAround(depth, 25, 25, 6)).curvature();
  CandidateParameters parameters = anyPlane();
  parameters.max_curvature = curvature * (1.0 + 1e-6);
  EXPECT_EQ(detect(depth, segment, parameters).size(), 1U);
  parameters.max_curvature = curvature * (1.0 - 1e-6);
  EXPECT_TRUE(detect(depth, segment, parameters).empty());
}

TEST(CandidateDetection, KnowsTheSurfaceOfANoiselessImage) {
  const Surface surface = surfaceAt(1.5, 0.5, -0.3);
  const DepthImage depth = render(surface, kCamera, kWidth, kHeight);
  const std::vector<PlaneCandidate> candidates =
      detect(depth, {segmentAt(ScanDirection::kRow, 3, 0, 63), segmentAt(ScanDirection::kColumn, 60, 0, 47)},
             anyPlane());
  ASSERT_EQ(candidates.size(), 2U);
  for (const PlaneCandidate& candidate : candidates) {
    EXPECT_LT((candidate.normal - surface.normal).norm(), 1e-4);
    EXPECT_NEAR(candidate.d, surface.d, 1e-4);
    EXPECT_LT(candidate.curvature, 1e-9);
  }
}

TEST(CandidateDetection, OfNothingIsNothing) {
  EXPECT_TRUE(detect(render(surfaceAt(1.5), kCamera, kWidth, kHeight), {}, anyPlane()).empty());
  EXPECT_TRUE(
      detect(blankDepth(kWidth, kHeight), {segmentAt(ScanDirection::kRow, 3, 0, 63)}, anyPlane()).empty());
}

TEST(WindowAround, IsCutOffAtTheBorder) {
  for (int side = 1; side <= 12; ++side) {
    for (int u = 0; u < 10; ++u) {
      for (int v = 0; v < 8; ++v) {
        const PixelWindow window = windowAround(u, v, side, 10, 8);
        EXPECT_EQ(window.first_u, std::max(0, u - side / 2));
        EXPECT_EQ(window.last_u, std::min(10, u - side / 2 + side));
        EXPECT_EQ(window.first_v, std::max(0, v - side / 2));
        EXPECT_EQ(window.last_v, std::min(8, v - side / 2 + side));
        EXPECT_TRUE(window.first_u <= u && u < window.last_u && window.first_v <= v && v < window.last_v);
      }
    }
  }
}

TEST(WindowAround, IsThePapers20By20Inside) {
  const PixelWindow window = windowAround(320, 240, 20, 640, 480);
  EXPECT_EQ(window.last_u - window.first_u, 20);
  EXPECT_EQ(window.last_v - window.first_v, 20);
}

}  // namespace
}  // namespace line_plane_segmentation
