// SPDX-License-Identifier: BSD-3-Clause
#include "refine/crease.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "support/clustered_image.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;

/// What is found of an image, and how its planes meet.
struct Found : ClusteredImage {
  Creases creases;

  explicit Found(const DepthImage& depth) : ClusteredImage(depth, adaptiveParameters(kWidth)) {
    creases.find(rays, grid, clusters, cluster_at);
  }
};

/// Two walls that meet in the middle of the picture, or one that ends there before another.
DepthImage walls(double left_yaw, double right_yaw, double right_distance = 1.8) {
  return halves(surfaceAt(1.8, left_yaw), surfaceAt(right_distance, right_yaw), kinectCamera(kWidth, kHeight),
                kWidth, kHeight);
}

/// The sign of what is seen on the left: whether the left wall, continued, lies before the right one there.
CreaseType expectedFold(const Found& found) {
  const int left = found.at(40, 120), right = found.at(280, 120);
  EXPECT_GE(left, 0);
  EXPECT_GE(right, 0);
  EXPECT_NE(left, right);
  const double x = found.rays.x[40], y = found.rays.y[120];
  const bool left_is_nearer = found.clusters[static_cast<std::size_t>(left)].plane.at(x, y) >
                              found.clusters[static_cast<std::size_t>(right)].plane.at(x, y);
  return left_is_nearer ? CreaseType::kConcave : CreaseType::kConvex;
}

TEST(Creases, TellsTheCornerOfARoomFromThatOfABox) {
  const Found one(walls(0.6, -0.6)), other(walls(-0.6, 0.6));
  ASSERT_EQ(one.clusters.size(), 2U);
  ASSERT_EQ(other.clusters.size(), 2U);
  EXPECT_EQ(one.creases.between(0, 1), expectedFold(one));
  EXPECT_EQ(other.creases.between(0, 1), expectedFold(other));
  EXPECT_NE(one.creases.between(0, 1), other.creases.between(0, 1));
  EXPECT_EQ(one.creases.between(1, 0), one.creases.between(0, 1));
  EXPECT_EQ(one.creases.between(0, 0), CreaseType::kNone);
}

TEST(Creases, PlanesWithNothingBesideEachOtherDoNotMeet) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.8, 0.6), kinectCamera(kWidth, kHeight), {0, 120, 0, 240}, depth);
  paint(surfaceAt(1.8, -0.6), kinectCamera(kWidth, kHeight), {200, 320, 0, 240}, depth);
  const Found found(depth);
  ASSERT_EQ(found.clusters.size(), 2U);
  EXPECT_EQ(found.creases.between(0, 1), CreaseType::kNone);
}

TEST(Creases, PlanesOnEitherSideOfAStepDoNotMeet) {
  const Found found(walls(0.3, 0.3, 3.0));
  ASSERT_EQ(found.clusters.size(), 2U);
  EXPECT_EQ(found.creases.between(0, 1), CreaseType::kNone);
}

/// How the walls of a corner meet, there being so many clusters.
CreaseType foldAmong(std::size_t count) {
  const Found corner(walls(0.6, -0.6));
  std::vector<PlaneCluster> clusters(count);
  clusters[0] = corner.clusters[0];
  clusters[1] = corner.clusters[1];
  Creases creases;
  creases.find(corner.rays, corner.grid, clusters, corner.cluster_at);
  return creases.between(0, 1);
}

TEST(Creases, AreFoundAmongUpTo200Clusters) {
  EXPECT_NE(foldAmong(200), CreaseType::kNone);
  EXPECT_EQ(foldAmong(201), CreaseType::kNone);
}

TEST(Creases, OfNothingIsNothing) {
  Creases creases;
  EXPECT_EQ(creases.between(0, 0), CreaseType::kNone);
  const Found found(blankDepth(kWidth, kHeight));
  EXPECT_EQ(found.creases.between(0, 0), CreaseType::kNone);
  creases.find(found.rays, CandidateGrid{}, {}, {});
  EXPECT_EQ(creases.between(0, 0), CreaseType::kNone);
}

/// The edge of two walls with one candidate each in `rows` rows, `columns_apart` columns apart.
CreaseType foldOf(int rows, int columns_apart) {
  Found corner(walls(0.6, -0.6));
  const CandidateGrid& grid = corner.grid;
  const int left = (grid.columns - columns_apart) / 2;
  const std::vector<int> all = corner.cluster_at;
  std::vector<int> few(all.size(), -1);
  for (int row = 0; row < rows; ++row) {
    for (const int column : {left, left + columns_apart}) {
      const int cell = grid.indexOf(column, row);
      EXPECT_GE(grid.candidate_at[static_cast<std::size_t>(cell)], 0);
      few[static_cast<std::size_t>(cell)] = column == left ? corner.at(40, 120) : corner.at(280, 120);
    }
  }
  corner.creases.find(corner.rays, grid, corner.clusters, few);
  return corner.creases.between(0, 1);
}

TEST(Creases, NeedTenVotesOfCandidatesAtMostTwoCrossingsApart) {
  EXPECT_EQ(foldOf(4, 1), CreaseType::kNone) << "eight votes: each of two candidates has one";
  EXPECT_NE(foldOf(5, 1), CreaseType::kNone);
  EXPECT_NE(foldOf(5, 2), CreaseType::kNone);
  EXPECT_EQ(foldOf(20, 3), CreaseType::kNone);
}

}  // namespace
}  // namespace line_plane_segmentation
