// SPDX-License-Identifier: BSD-3-Clause
// Parts of a plane that distortion bends away from it.
#include "planes/plane_continuation.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

#include "support/clustered_image.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

/// An image whose candidates left of a column are one cluster, those right of it another.
struct TwoClusters : CandidateImage {
  std::vector<PlaneCluster> clusters{2};
  std::vector<int> cluster_at, plane_of;

  TwoClusters(const DepthImage& depth, int border) : CandidateImage(depth, adaptiveParameters(kWidth)) {
    cluster_at.assign(grid.candidate_at.size(), -1);
    for (const CrossingCandidate& candidate : grid.candidates) {
      const std::size_t index = candidate.u < border ? 0 : 1;
      cluster_at[static_cast<std::size_t>(candidate.cell)] = static_cast<int>(index);
      PlaneCluster& cluster = clusters[index];
      cluster.moments += candidate.moments;
      ++cluster.candidates;
    }
    for (PlaneCluster& cluster : clusters)
      EXPECT_TRUE(cluster.moments.fit(cluster.plane, cluster.squared_error));
  }

  const std::vector<int>& find() {
    PlaneContinuation().find(rays, grid, clusters, cluster_at, adaptiveParameters(kWidth), plane_of);
    return plane_of;
  }
};

// Noise as a Kinect's, since the uncertainty of slopes comes from it.
TwoClusters clustersOf(const Surface& left, const Surface& right, int border) {
  DepthImage depth = halves(left, right, kCamera, kWidth, kHeight);
  Random random(3);
  addNoise({}, 1.0, random, depth);
  return {depth, border};
}

using Planes = std::vector<int>;

TEST(PlaneContinuation, OnePlaneTurnsALittle) {
  // The right cluster is the smaller one: it begins behind the crease.
  TwoClusters image = clustersOf(surfaceAt(2.0), surfaceAt(2.0, 0.1), kWidth / 2);
  image.clusters[1].candidates = image.clusters[0].candidates / 2;
  EXPECT_EQ(image.find(), (Planes{0, 0}));
}

TEST(PlaneContinuation, TwoPlanesMeetInACrease) {
  TwoClusters image = clustersOf(surfaceAt(2.0), surfaceAt(2.0, 0.5), kWidth / 2);
  EXPECT_EQ(image.find(), (Planes{0, 1}));
}

TEST(PlaneContinuation, TwoPlanesAreAStepApart) {
  TwoClusters image = clustersOf(surfaceAt(2.0), surfaceAt(2.1), kWidth / 2);
  EXPECT_EQ(image.find(), (Planes{0, 1}));
}

// Two tolerances are allowed between the planes, since distortion bends their ends away from each other, but
// not between the surfaces.
TEST(PlaneContinuation, TwoPlanesAreASmallStepApart) {
  TwoClusters image = clustersOf(surfaceAt(3.5), surfaceAt(3.55), kWidth / 2);
  EXPECT_EQ(image.find(), (Planes{0, 1}));
}

TEST(PlaneContinuation, TheSmallerContinuesTheLarger) {
  TwoClusters image = clustersOf(surfaceAt(2.0), surfaceAt(2.0), 100);
  ASSERT_LT(image.clusters[0].candidates, image.clusters[1].candidates);
  EXPECT_EQ(image.find(), (Planes{1, 1}));
}

TEST(PlaneContinuation, WhatIsNoPlaneContinuesALargerOneOrNone) {
  TwoClusters image = clustersOf(surfaceAt(2.0), surfaceAt(2.0), 100);
  image.clusters[0].is_plane = false;
  EXPECT_EQ(image.find(), (Planes{1, 1}));
  image.clusters[0].is_plane = true;
  image.clusters[1].is_plane = false;
  EXPECT_EQ(image.find(), (Planes{0, -1})) << "the larger one is no plane";
  image.clusters[0].is_plane = false;
  EXPECT_EQ(image.find(), (Planes{-1, -1}));
}

TEST(PlaneContinuation, NothingIsSaidOfClustersApart) {
  TwoClusters image = clustersOf(surfaceAt(2.0), surfaceAt(2.0), kWidth / 2);
  // A gap of more crossings than distortion makes.
  for (const CrossingCandidate& candidate : image.grid.candidates) {
    if (std::abs(candidate.u - kWidth / 2) < 3 * image.grid.spacing)
      image.cluster_at[static_cast<std::size_t>(candidate.cell)] = -1;
  }
  EXPECT_EQ(image.find(), (Planes{0, 1}));
}

TEST(PlaneContinuation, FindsNothingInAnEmptyImage) {
  std::vector<int> plane_of{7};
  PlaneContinuation().find({}, {}, {}, {}, adaptiveParameters(kWidth), plane_of);
  EXPECT_TRUE(plane_of.empty());
}

}  // namespace
}  // namespace line_plane_segmentation
