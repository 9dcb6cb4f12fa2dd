// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/cluster_forest.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <vector>

#include "support/random.h"

namespace line_plane_segmentation {
namespace {

constexpr std::initializer_list<double> kRounds = {0.25, 1.0, 1.0};

// A patch on w = a x + b y + c with some noise, its pixels scattered about (x, y).
SurfacePatch patchOn(const InverseDepthPlane& plane, double x, double y, Random& random) {
  SurfacePatch patch;
  for (int i = 0; i < 20; ++i) {
    const double px = x + random.uniform(-0.02, 0.02), py = y + random.uniform(-0.02, 0.02);
    const double w = plane.at(px, py) + random.uniform(-0.001, 0.001);
    patch.moments += RegressionMoments{px * px, px * py, py * py, px, py, 1.0, px * w, py * w, w, w * w, 1.0};
  }
  patch.moments.scale(1e6);  // a tolerance of 0.001
  patch.squared_error = patch.moments.fit(patch.plane);
  patch.is_planar = true;
  return patch;
}

ClusterForest fourPatches() {
  Random random(3);
  ClusterForest forest;
  const InverseDepthPlane near{0.0, 0.0, 1.0}, far{0.0, 0.0, 0.5};
  forest.add(patchOn(near, 0.0, 0.0, random), 0.1);
  forest.add(patchOn(near, 0.1, 0.0, random), 0.1);
  forest.add(patchOn(far, 0.2, 0.0, random), 0.1);
  forest.add(SurfacePatch{}, 0.1);
  return forest;
}

TEST(ClusterForest, StartsWithEachPatchForItself) {
  ClusterForest forest = fourPatches();
  ASSERT_EQ(forest.size(), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(forest.find(i), i);
  EXPECT_EQ(forest.cluster(0).patches, 1);
  EXPECT_EQ(forest.cluster(3).patches, 0);
}

TEST(ClusterForest, CostIsTheErrorThatACommonPlaneAddsToTheSmaller) {
  const ClusterForest forest = fourPatches();
  const double cost = forest.costOf(0, 1);
  RegressionMoments both = forest.cluster(0).moments;
  both += forest.cluster(1).moments;
  InverseDepthPlane plane;
  const double together = both.fit(plane);
  EXPECT_NEAR(cost, (together - forest.cluster(0).squared_error - forest.cluster(1).squared_error) / 20.0,
              1e-9);
  EXPECT_LT(cost, 1.0);
  EXPECT_GT(forest.costOf(1, 2), 1.0);
  ClusterForest nothing;
  nothing.add(SurfacePatch{}, 0.1);
  nothing.add(SurfacePatch{}, 0.1);
  EXPECT_EQ(nothing.costOf(0, 1), std::numeric_limits<double>::max());
}

TEST(ClusterForest, MergesTheNeighborsThatLieInOnePlane) {
  ClusterForest forest = fourPatches();
  for (int i = 0; i < 3; ++i) forest.addPair(i, i + 1);
  forest.addPair(0, 0);
  forest.mergePairs(8.0, kRounds);
  EXPECT_EQ(forest.find(0), forest.find(1));
  EXPECT_NE(forest.find(0), forest.find(2));
  EXPECT_NE(forest.find(2), forest.find(3)) << "what is not planar merges with nothing";
  EXPECT_EQ(forest.cluster(forest.find(0)).patches, 2);
  forest.mergePairs(1e9, kRounds);
  EXPECT_NE(forest.find(0), forest.find(2)) << "pairs are forgotten";
}

// Two patches that become alike when one of them has grown.
TEST(ClusterForest, WaitsForPairsThatAreDearAtFirst) {
  int dear = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    ClusterForest forest;
    for (const double x : {0.0, 0.1, 0.2}) forest.add(patchOn({0.0, 0.0, 1.0}, x, 0.0, random), 0.1);
    ClusterForest grown = forest;
    grown.merge(0, 1);
    const double limit = 1.01 * grown.costOf(0, 2), before = forest.costOf(0, 2);
    if (before < limit || before > 4.0 * limit || forest.costOf(0, 1) > limit) continue;
    forest.addPair(0, 2);
    forest.addPair(0, 1);
    forest.mergePairs(limit, {1.0, 1.0});
    EXPECT_EQ(forest.find(0), forest.find(2)) << before / limit;
    ++dear;
  }
  EXPECT_GT(dear, 5);
}

TEST(ClusterForest, CanBeCleared) {
  ClusterForest forest = fourPatches();
  forest.addPair(0, 1);
  forest.clear();
  EXPECT_EQ(forest.size(), 0);
  forest.mergePairs(8.0, kRounds);
  EXPECT_EQ(forest.size(), 0);
}

// Whatever the order of what they are made of, clusters know their sums.
TEST(ClusterForest, KnowsWhatItsClustersAreMadeOf) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    ClusterForest forest;
    std::vector<SurfacePatch> patches;
    for (int i = 0; i < 30; ++i) {
      const InverseDepthPlane plane{0.0, 0.0, random.integer(0, 1) == 0 ? 0.5 : 0.51};
      patches.push_back(patchOn(plane, 0.1 * i, 0.05 * (i % 5), random));
      forest.add(patches.back(), 0.01);
    }
    for (int i = 0; i < 60; ++i) forest.addPair(random.integer(0, 29), random.integer(0, 29));
    forest.mergePairs(8.0, kRounds);
    std::vector<RegressionMoments> sums(30);
    std::vector<int> counts(30, 0);
    for (int i = 0; i < 30; ++i) {
      const std::size_t root = static_cast<std::size_t>(forest.find(i));
      sums[root] += patches[static_cast<std::size_t>(i)].moments;
      ++counts[root];
    }
    for (int i = 0; i < 30; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      if (forest.find(i) != i) continue;
      EXPECT_EQ(forest.cluster(i).patches, counts[k]);
      EXPECT_NEAR(forest.cluster(i).moments.ww, sums[k].ww, 1e-6 * sums[k].ww);
      EXPECT_NEAR(forest.cluster(i).share, 0.01 * counts[k], 1e-12);
      InverseDepthPlane plane;
      EXPECT_NEAR(forest.cluster(i).squared_error, sums[k].fit(plane), 1e-4);
    }
  }
}

}  // namespace
}  // namespace line_plane_segmentation
