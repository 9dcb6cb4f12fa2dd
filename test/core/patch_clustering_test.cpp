// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/patch_clustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);
const ViewRays kRays = raysOf(kCamera, kWidth, kHeight);

/// The clusters of an image.
struct Clusters {
  PatchGrid grid;
  std::vector<PatchCluster> clusters;
  std::vector<int> cluster_of;

  explicit Clusters(const DepthImage& depth, const Parameters& parameters = adaptiveParameters(kWidth)) {
    PatchDetector().detect(depth, kRays, parameters, grid);
    PatchClusterer().cluster(depth, kRays, grid, parameters, clusters, cluster_of);
  }

  /// The cluster of the patch nearest to a pixel, or -1.
  int at(int u, int v) const {
    const int c = std::min(u / grid.spacing, grid.columns - 1), r = std::min(v / grid.spacing, grid.rows - 1);
    return cluster_of[static_cast<std::size_t>(grid.indexOf(c, r))];
  }

  /// Whether the cluster at a pixel is the surface.
  bool isAt(int u, int v, const Surface& surface) const {
    const int k = at(u, v);
    if (k < 0) return false;
    const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(k)].plane;
    const Eigen::Vector3d normal = -Eigen::Vector3d(plane.a, plane.b, plane.c).normalized();
    return normal.dot(surface.normal) > std::cos(0.02) &&
           std::abs(1.0 / plane.inverseDistance() - surface.d) < 0.02;
  }
};

DepthImage noisy(DepthImage depth, double factor = 0.7) {
  Random random(9);
  addNoise({}, factor, random, depth);
  return depth;
}

DepthImage halves(const Surface& left, const Surface& right) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(left, kCamera, {0, kWidth / 2, 0, kHeight}, depth);
  paint(right, kCamera, {kWidth / 2, kWidth, 0, kHeight}, depth);
  return depth;
}

TEST(PatchClusterer, MakesOneClusterOfOnePlane) {
  const Surface surface = surfaceAt(2.0, 0.5, -0.3);
  const Clusters found(noisy(render(surface, kCamera, kWidth, kHeight)));
  ASSERT_EQ(found.clusters.size(), 1U);
  EXPECT_TRUE(found.isAt(160, 120, surface));
  EXPECT_TRUE(found.isAt(40, 200, surface));
  EXPECT_GT(found.clusters[0].patches, 0.85 * found.grid.columns * found.grid.rows);
}

TEST(PatchClusterer, PartsPlanesAtACreaseAndAtAStep) {
  const Surface pairs[][2] = {{surfaceAt(1.8, 0.4), surfaceAt(1.8, -0.4)}, {surfaceAt(1.4), surfaceAt(1.5)}};
  for (const auto& pair : pairs) {
    const Clusters found(noisy(halves(pair[0], pair[1])));
    ASSERT_EQ(found.clusters.size(), 2U);
    EXPECT_TRUE(found.isAt(60, 120, pair[0]));
    EXPECT_TRUE(found.isAt(260, 120, pair[1]));
  }
}

/// A table top cut in two by a strip of something else.
DepthImage cutTable(const Surface& table, const Surface& strip) {
  DepthImage depth = render(table, kCamera, kWidth, kHeight);
  paint(strip, kCamera, {130, 190, 0, kHeight}, depth);
  return noisy(depth);
}

TEST(PatchClusterer, JoinsWhatANearerThingCutsApart) {
  const Surface table = surfaceAt(1.5, 0.0, -0.5);
  const Clusters found(cutTable(table, surfaceAt(1.0)));
  EXPECT_GE(found.at(40, 120), 0);
  EXPECT_EQ(found.at(40, 120), found.at(280, 120));
  EXPECT_TRUE(found.isAt(40, 120, table));
  EXPECT_NE(found.at(160, 120), found.at(40, 120));
}

TEST(PatchClusterer, KeepsApartWhatOpenSpaceParts) {
  const Surface table = surfaceAt(1.5, 0.0, -0.5);
  const Clusters found(cutTable(table, surfaceAt(3.0)));
  EXPECT_GE(found.at(40, 120), 0);
  EXPECT_GE(found.at(280, 120), 0);
  EXPECT_NE(found.at(40, 120), found.at(280, 120));
}

TEST(PatchClusterer, JoinsNothingApartIfThatMayCostNothing) {
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.coplanar_cost = 0.0;
  const Clusters found(cutTable(surfaceAt(1.5, 0.0, -0.5), surfaceAt(1.0)), parameters);
  EXPECT_NE(found.at(40, 120), found.at(280, 120));
}

TEST(PatchClusterer, DropsClustersOfTooFewPatches) {
  const DepthImage depth = noisy(halves(surfaceAt(1.4), surfaceAt(1.5)));
  Parameters parameters = adaptiveParameters(kWidth);
  const int patches = Clusters(depth, parameters).clusters.at(0).patches;
  parameters.clusters.min_patches = patches + 200;
  const Clusters found(depth, parameters);
  EXPECT_TRUE(found.clusters.empty());
  for (const int cluster : found.cluster_of) EXPECT_EQ(cluster, -1);
}

TEST(PatchClusterer, KnowsTheSumsOfItsPatches) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Clusters found(randomScene(seed, kWidth, kHeight));
    ASSERT_EQ(found.cluster_of.size(), found.grid.patches.size());
    std::vector<PatchCluster> sums(found.clusters.size());
    for (std::size_t i = 0; i < found.cluster_of.size(); ++i) {
      const int k = found.cluster_of[i];
      ASSERT_LT(k, static_cast<int>(found.clusters.size()));
      if (k < 0) continue;
      ASSERT_TRUE(found.grid.patches[i].is_planar);
      sums[static_cast<std::size_t>(k)].moments += found.grid.patches[i].moments;
      ++sums[static_cast<std::size_t>(k)].patches;
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const PatchCluster& cluster = found.clusters[k];
      InverseDepthPlane plane;
      const double squared_error = sums[k].moments.fit(plane);
      EXPECT_EQ(cluster.patches, sums[k].patches);
      EXPECT_EQ(cluster.moments.pixels, sums[k].moments.pixels);
      EXPECT_NEAR(cluster.squared_error, squared_error, 1e-6 * (1.0 + squared_error));
      EXPECT_NEAR(cluster.plane.a, plane.a, 1e-9);
      EXPECT_NEAR(cluster.plane.b, plane.b, 1e-9);
      EXPECT_NEAR(cluster.plane.c, plane.c, 1e-9);
    }
  }
}

TEST(PatchClusterer, OfNothingIsNothing) {
  const Clusters found(blankDepth(kWidth, kHeight));
  EXPECT_TRUE(found.clusters.empty());
  EXPECT_EQ(found.cluster_of.size(), found.grid.patches.size());
  std::vector<PatchCluster> clusters(3);
  std::vector<int> cluster_of(3);
  PatchClusterer().cluster(blankDepth(0, 0), ViewRays{}, PatchGrid{}, adaptiveParameters(kWidth), clusters,
                           cluster_of);
  EXPECT_TRUE(clusters.empty());
  EXPECT_TRUE(cluster_of.empty());
}

}  // namespace
}  // namespace line_plane_segmentation
