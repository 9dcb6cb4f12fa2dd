// SPDX-License-Identifier: BSD-3-Clause
// Parts of a plane that distortion bends away from it.
#include "planes/plane_continuation.h"

#include <gtest/gtest.h>

#include <cmath>
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

/// An image whose candidates at some pixels are the second cluster, the others the first.
struct TwoClusters : CandidateImage {
  std::vector<PlaneCluster> clusters{2};
  std::vector<int> cluster_at, plane_of;

  template <typename Predicate>
  TwoClusters(const DepthImage& depth, Predicate&& is_second)
      : CandidateImage(depth, adaptiveParameters(kWidth)) {
    cluster_at.assign(grid.candidate_at.size(), -1);
    for (const CrossingCandidate& candidate : grid.candidates) {
      const std::size_t index = is_second(candidate.u, candidate.v) ? 1 : 0;
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
  return {depth, [border](int u, int) { return u >= border; }};
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

// At a larger distance the step of a slanted or bent surface is not known.
TEST(PlaneContinuation, StepsAreMeasuredOverOneCrossingThatIsInNeither) {
  const auto find_over = [](int crossings) {
    TwoClusters image(halves(surfaceAt(3.5), surfaceAt(3.55), kCamera, kWidth, kHeight),
                      [](int u, int) { return u >= kWidth / 2; });
    for (int row = 0; row < image.grid.rows; ++row) {
      for (int column = 16; column < 16 + crossings; ++column)
        image.cluster_at[static_cast<std::size_t>(image.grid.indexOf(column, row))] = -1;
    }
    return image.find();
  };
  EXPECT_EQ(find_over(1), (Planes{0, 1}));
  EXPECT_EQ(find_over(2), (Planes{0, 0}));
}

// The steps on both sides of a stripe have the same sign, whichever side the scanline comes from.
TEST(PlaneContinuation, AStripeStandsASmallStepBack) {
  DepthImage depth = render(surfaceAt(3.5), kCamera, kWidth, kHeight);
  paint(surfaceAt(3.55), kCamera, {120, 200, 0, kHeight}, depth);
  Random random(3);
  addNoise({}, 1.0, random, depth);
  TwoClusters image(depth, [](int u, int) { return u >= 120 && u < 200; });
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

constexpr int kBorder = 200;  // [px] first column of the smaller cluster

/// Two clusters, whose left one is of a wall 2 m away and the larger.
struct TwoParts : TwoClusters {
  explicit TwoParts(const Surface& right = surfaceAt(2.0))
      : TwoClusters(imageOf(right), [](int u, int) { return u >= kBorder; }) {}

  static DepthImage imageOf(const Surface& right) {
    DepthImage depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
    paint(right, kCamera, {kBorder, kWidth, 0, kHeight}, depth);
    return depth;
  }
  bool isContinued() { return find() == Planes{0, 0}; }
};

/// Whether the smaller cluster continues the larger one, if they differ by `tolerances`.
bool isContinuedAcrossGap(double tolerances) {
  TwoParts parts;
  const Parameters p = adaptiveParameters(kWidth);
  const DepthTolerance tolerance{p.noise, p.patches.patch_noise_factor, p.patches.patch_distance};
  parts.clusters[1].plane.c += tolerances * tolerance.at(0.5, 0.5);
  return parts.isContinued();
}

TEST(PlaneContinuation, MayDifferByTwoTolerances) {
  EXPECT_TRUE(isContinuedAcrossGap(1.6));
  EXPECT_FALSE(isContinuedAcrossGap(2.5));
}

/// The same if the smaller cluster turns away where both meet.
/// @param turn  [-] change of relative depth per unit of the tangent of the view angle
/// @param deviation  standard deviation of its slope, in the same unit
bool isContinuedAtTurn(double turn, double deviation) {
  const double rho = 0.5, slope = turn * rho, x_border = (kBorder - 0.5 - kCamera.cx) / kCamera.fx;
  const Eigen::Vector3d coefficients(slope, 0.0, rho - slope * x_border);
  TwoParts parts({-coefficients.normalized(), 1.0 / coefficients.norm()});
  PlaneCluster& cluster = parts.clusters[1];
  // Twelve pixels share an error.
  const RegressionMoments& m = cluster.moments;
  const double cxx = m.xx - m.x * m.x / m.weight, cyy = m.yy - m.y * m.y / m.weight;
  const double cxy = m.xy - m.x * m.y / m.weight;
  cluster.squared_error =
      std::pow(deviation * rho, 2) * (cxx * cyy - cxy * cxy) / (cxx + cyy) * m.pixels / 12.0;
  return parts.isContinued();
}

TEST(PlaneContinuation, MayTurnByAFifthAndTwoStandardDeviations) {
  EXPECT_TRUE(isContinuedAtTurn(0.15, 0.0));
  EXPECT_FALSE(isContinuedAtTurn(0.27, 0.0));
  EXPECT_TRUE(isContinuedAtTurn(0.27, 0.05)) << "up to 0.3";
  EXPECT_FALSE(isContinuedAtTurn(0.35, 0.05));
}

TEST(PlaneContinuation, ComparesPlanesWhereTheLowerOneTurnsAway) {
  constexpr int kRow = 200;
  const double rho = 0.5, slope = 0.15 * rho, y_border = (kRow - 0.5 - kCamera.cy) / kCamera.fy;
  const Eigen::Vector3d coefficients(0.0, slope, rho - slope * y_border);
  DepthImage depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
  paint({-coefficients.normalized(), 1.0 / coefficients.norm()}, kCamera, {0, kWidth, kRow, kHeight}, depth);
  TwoClusters image(depth, [](int, int v) { return v >= kRow; });
  EXPECT_EQ(image.find(), (Planes{0, 0}));
}

TEST(PlaneContinuation, GoesOverThreeCrossingsThatAreInNeither) {
  const auto is_continued_over = [](int crossings) {
    TwoParts parts;
    const CandidateGrid& grid = parts.grid;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 20; column < 20 + crossings; ++column)
        parts.cluster_at[static_cast<std::size_t>(grid.indexOf(column, row))] = -1;
    }
    return parts.isContinued();
  };
  EXPECT_TRUE(is_continued_over(3));
  EXPECT_FALSE(is_continued_over(4));
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
