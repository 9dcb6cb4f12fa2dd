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
  return patch;
}

/// Two patches of one plane, and one of another.
class ThreePatches {
 public:
  ThreePatches() {
    for (const SurfacePatch& patch : patches_) forest.add(patch, 0.1);
  }

 private:
  Random random_{3};
  const InverseDepthPlane near_{0.0, 0.0, 1.0}, far_{0.0, 0.0, 0.5};
  const std::vector<SurfacePatch> patches_ = {
      patchOn(near_, 0.0, 0.0, random_), patchOn(near_, 0.1, 0.0, random_), patchOn(far_, 0.2, 0.0, random_)};

 public:
  ClusterForest forest;
};

TEST(ClusterForest, StartsWithEachPatchForItself) {
  ThreePatches three;
  ASSERT_EQ(three.forest.size(), 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(three.forest.find(i), i);
    EXPECT_EQ(three.forest.patchesOf(i), 1);
    EXPECT_EQ(three.forest.shareOf(i), 0.1);
  }
}

TEST(ClusterForest, CostIsTheErrorThatACommonPlaneAddsToTheSmaller) {
  const ThreePatches three;
  const ClusterForest& forest = three.forest;
  const double cost = forest.costOf(0, 1);
  RegressionMoments both = forest.fitOf(0).moments;
  both += forest.fitOf(1).moments;
  InverseDepthPlane plane;
  const double together = both.fit(plane);
  EXPECT_NEAR(cost, (together - forest.fitOf(0).squared_error - forest.fitOf(1).squared_error) / 20.0, 1e-9);
  EXPECT_LT(cost, 1.0);
  EXPECT_GT(forest.costOf(1, 2), 1.0);
  ClusterForest nothing;
  const SurfacePatch empty;
  nothing.add(empty, 0.1);
  nothing.add(empty, 0.1);
  EXPECT_EQ(nothing.costOf(0, 1), std::numeric_limits<double>::max());
}

TEST(ClusterForest, MergesTheNeighborsThatLieInOnePlane) {
  ThreePatches three;
  ClusterForest& forest = three.forest;
  for (int i = 0; i < 2; ++i) forest.addPair(i, i + 1);
  forest.addPair(0, 0);
  forest.mergePairs(8.0, kRounds);
  EXPECT_EQ(forest.find(0), forest.find(1));
  EXPECT_NE(forest.find(0), forest.find(2));
  EXPECT_EQ(forest.patchesOf(forest.find(0)), 2);
  forest.mergePairs(1e9, kRounds);
  EXPECT_NE(forest.find(0), forest.find(2)) << "pairs are forgotten";
}

// Two patches that become alike when one of them has grown.
TEST(ClusterForest, WaitsForPairsThatAreDearAtFirst) {
  int dear = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    std::vector<SurfacePatch> patches;
    for (const double x : {0.0, 0.1, 0.2}) patches.push_back(patchOn({0.0, 0.0, 1.0}, x, 0.0, random));
    ClusterForest forest;
    for (const SurfacePatch& patch : patches) forest.add(patch, 0.1);
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
  ThreePatches three;
  ClusterForest& forest = three.forest;
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
    }
    for (const SurfacePatch& patch : patches) forest.add(patch, 0.01);
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
      const PatchCluster cluster = forest.cluster(i);
      EXPECT_EQ(cluster.patches, counts[k]);
      EXPECT_NEAR(cluster.moments.ww, sums[k].ww, 1e-6 * sums[k].ww);
      EXPECT_NEAR(cluster.share, 0.01 * counts[k], 1e-12);
      InverseDepthPlane plane;
      EXPECT_NEAR(cluster.squared_error, sums[k].fit(plane), 1e-4);
    }
  }
}

}  // namespace
}  // namespace line_plane_segmentation
