// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_extraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lines/line_extraction.h"
#include "planes/candidate_detection.h"
#include "reference_extraction.h"
#include "refine/label_runs.h"
#include "refine/plane_measurement.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// An image with its rays, candidates and parameters.
struct Problem {
  CameraIntrinsics camera;
  DepthImage depth;
  ViewRays rays;
  std::vector<PlaneCandidate> candidates;
  Parameters parameters;

  Problem(const DepthImage& image, const Parameters& p)
      : camera(kinectCamera(image.width, image.height)),
        depth(image),
        rays(raysOf(camera, image.width, image.height)),
        parameters(p) {}

  /// Candidates as stages 2 and 3 find them.
  void detect() {
    std::vector<LineSegment> segments;
    LineExtractor().extract(depth, camera, parameters, segments);
    detectCandidates(depth, rays, segments, parameters.candidates, candidates);
  }

  /// A candidate at a pixel, with the plane of the surface.
  void add(int u, int v, const Surface& surface) {
    PlaneCandidate candidate;
    candidate.u = u;
    candidate.v = v;
    candidate.normal = surface.normal;
    candidate.d = surface.d;
    candidates.push_back(candidate);
  }
};

std::vector<std::uint16_t> extractLabels(PlaneExtractor& extractor, const Problem& problem, int& count) {
  std::vector<std::uint16_t> labels(problem.depth.z.size(), 0);
  count = extractor.extract(problem.depth, problem.rays, problem.candidates, problem.parameters, labels);
  return labels;
}

/// Expects the same labels, pixel by pixel, and the same planes as the slow transcription of the paper finds.
void expectAsReference(PlaneExtractor& extractor, const Problem& problem) {
  const ReferenceResult reference =
      referenceExtraction(problem.depth, problem.rays, problem.candidates, problem.parameters);
  int count = 0;
  const std::vector<std::uint16_t> labels = extractLabels(extractor, problem, count);
  ASSERT_EQ(static_cast<std::size_t>(count), reference.planes.size());
  ASSERT_EQ(labels, reference.labels);

  LabelRuns runs;
  runs.scan(labels, problem.depth.width, problem.depth.height);
  Segmentation segmentation;
  PlaneMeasurement().measure(problem.depth, problem.rays, problem.camera, count, 0.0, runs, segmentation);
  std::size_t measured = 0;  // what is seen edge-on is no plane: the measurement leaves it out
  for (const std::optional<PlaneFit>& plane : reference.planes) {
    if (!plane) continue;
    ASSERT_LT(measured, segmentation.planes.size());
    const SegmentedPlane& found = segmentation.planes[measured++];
    EXPECT_LT((found.normal - plane->normal).norm(), 1e-9) << measured;
    EXPECT_NEAR(found.d, plane->d, 1e-9) << measured;
    EXPECT_LT((found.centroid - plane->centroid).norm(), 1e-9) << measured;
  }
  EXPECT_EQ(measured, segmentation.planes.size());
}

/// Parameters for images of a few dozen pixels, each time a little different.
Parameters smallImageParameters(Random& random) {
  Parameters p = paperParameters(64);
  p.scanlines.scanline_spacing = random.integer(3, 9);
  p.lines.min_line_points = 9;
  p.candidates.points_per_segment = 1 + 2 * random.integer(0, 2);
  p.candidates.normal_window = random.integer(3, 8);
  p.candidates.min_window_points = random.integer(3, 20);
  p.candidates.max_curvature = random.uniform(0.01, 1.0 / 3.0);
  p.extraction.plane_distance = random.uniform(0.003, 0.06);
  p.extraction.neighbor_distance = random.uniform(0.02, 0.2);
  p.extraction.min_plane_inliers = random.integer(4, 60);
  return p;
}

/// Candidates that no line gave: planes of any pixel's window, arbitrary ones, and some of them twice.
void addRandomCandidates(int count, Random& random, Problem& problem) {
  for (int i = 0; i < count; ++i) {
    const int u = random.integer(0, problem.depth.width - 1), v = random.integer(0, problem.depth.height - 1);
    const Surface tilted = surfaceAt(1.0, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    problem.add(u, v, {tilted.normal, -tilted.normal.dot(pointAt(problem.depth, problem.rays, u, v))});
    if (random.chance(0.3)) {
      const std::size_t again =
          static_cast<std::size_t>(random.integer(0, static_cast<int>(problem.candidates.size()) - 1));
      problem.candidates.push_back(PlaneCandidate(problem.candidates[again]));
    }
  }
}

TEST(PlaneExtraction, IsThePapersAlgorithmOnSmallImages) {
  PlaneExtractor extractor;  // one for all: nothing may stay from an image before
  int images_with_planes = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(1000 + seed);
    const int width = random.integer(12, 80), height = random.integer(12, 60);
    Problem problem(randomScene(seed, width, height), smallImageParameters(random));
    problem.detect();
    addRandomCandidates(random.integer(0, 12), random, problem);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectAsReference(extractor, problem);
    if (HasFatalFailure()) return;
    int count = 0;
    extractLabels(extractor, problem, count);
    images_with_planes += count > 1 ? 1 : 0;
  }
  EXPECT_GT(images_with_planes, 150) << "the images are too poor to test anything";
}

TEST(PlaneExtraction, IsThePapersAlgorithmOnVgaImages) {
  PlaneExtractor extractor;
  for (const std::uint64_t seed : {15U, 18U, 20U}) {
    Problem problem(randomScene(seed, 640, 480), paperParameters(640));
    problem.parameters.scanlines.scanline_spacing = 60;  // fewer candidates, for the reference's sake
    problem.detect();
    int count = 0;
    extractLabels(extractor, problem, count);
    EXPECT_GE(count, 4) << "the image is too poor to test anything";
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectAsReference(extractor, problem);
  }
}

/// Two squares of equal size, side by side at different depths, and parameters under which each is a plane.
Problem twoSquares() {
  DepthImage depth = blankDepth(40, 20);
  const CameraIntrinsics camera = kinectCamera(40, 20);
  paint(surfaceAt(1.0), camera, {0, 20, 0, 20}, depth);
  paint(surfaceAt(1.5), camera, {20, 40, 0, 20}, depth);
  Parameters p = paperParameters(64);
  p.candidates.normal_window = 5;
  p.candidates.min_window_points = 10;
  p.extraction.min_plane_inliers = 100;
  p.extraction.neighbor_distance = 0.2;
  return Problem(depth, p);
}

TEST(PlaneExtraction, TakesTheFirstOfEqualCandidates) {
  PlaneExtractor extractor;
  for (const bool right_first : {false, true}) {
    Problem problem = twoSquares();
    problem.add(10, 10, surfaceAt(1.0));
    problem.add(30, 10, surfaceAt(1.5));
    if (right_first) std::swap(problem.candidates[0], problem.candidates[1]);
    int count = 0;
    const std::vector<std::uint16_t> labels = extractLabels(extractor, problem, count);
    EXPECT_EQ(count, 2);
    EXPECT_EQ(labels[problem.depth.index(10, 10)], right_first ? 2 : 1);
    EXPECT_EQ(labels[problem.depth.index(30, 10)], right_first ? 1 : 2);
    expectAsReference(extractor, problem);
  }
}

TEST(PlaneExtraction, NeedsTheMinimumOfInliers) {
  PlaneExtractor extractor;
  Problem problem = twoSquares();
  problem.add(10, 10, surfaceAt(1.0));
  for (const int minimum : {400, 401}) {
    problem.parameters.extraction.min_plane_inliers = minimum;
    int count = 0;
    const std::vector<std::uint16_t> labels = extractLabels(extractor, problem, count);
    EXPECT_EQ(count, minimum == 400 ? 1 : 0);
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 1), minimum == 400 ? 400 : 0);
  }
}

TEST(PlaneExtraction, NeedsValidPointsInTheWindow) {
  PlaneExtractor extractor;
  Problem problem = twoSquares();
  problem.add(10, 10, surfaceAt(1.0));
  for (const int minimum : {25, 26}) {
    problem.parameters.candidates.min_window_points = minimum;
    int count = 0;
    extractLabels(extractor, problem, count);
    EXPECT_EQ(count, minimum == 25 ? 1 : 0);
  }
}

TEST(PlaneExtraction, StartsFromItsOwnPixelOnly) {
  PlaneExtractor extractor;
  Problem problem = twoSquares();
  problem.add(10, 10, surfaceAt(1.5));  // its plane has inliers, but none that it can reach
  int count = 0;
  extractLabels(extractor, problem, count);
  EXPECT_EQ(count, 0);
  problem.add(30, 10, surfaceAt(1.5));
  extractLabels(extractor, problem, count);
  EXPECT_EQ(count, 1);
}

TEST(PlaneExtraction, OfNothingIsNothing) {
  PlaneExtractor extractor;
  int count = -1;
  const Problem no_candidates = twoSquares();
  const std::vector<std::uint16_t> labels = extractLabels(extractor, no_candidates, count);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), 800);

  Problem no_depth(blankDepth(40, 20), no_candidates.parameters);
  no_depth.add(10, 10, surfaceAt(1.0));
  extractLabels(extractor, no_depth, count);
  EXPECT_EQ(count, 0);

  Problem no_pixels(blankDepth(0, 0), no_candidates.parameters);
  extractLabels(extractor, no_pixels, count);
  EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace line_plane_segmentation
