// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/patch_clustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/clustered_image.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);
const ViewRays kRays = raysOf(kCamera, kWidth, kHeight);

/// The clusters of an image.
struct Clusters : ClusteredImage {
  explicit Clusters(const DepthImage& depth, const Parameters& parameters = adaptiveParameters(kWidth))
      : ClusteredImage(depth, parameters) {}

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

TEST(PatchClusterer, MakesOneClusterOfOnePlane) {
  const Surface surface = surfaceAt(2.0, 0.5, -0.3);
  const Clusters found(noisy(render(surface, kCamera, kWidth, kHeight)));
  ASSERT_EQ(found.clusters.size(), 1U);
  EXPECT_TRUE(found.isAt(160, 120, surface));
  EXPECT_TRUE(found.isAt(40, 200, surface));
  EXPECT_GT(found.clusters[0].patches, 0.85 * found.levels.coarse.columns * found.levels.coarse.rows);
}

TEST(PatchClusterer, PartsPlanesAtACreaseAndAtAStep) {
  const Surface pairs[][2] = {{surfaceAt(1.8, 0.4), surfaceAt(1.8, -0.4)}, {surfaceAt(1.4), surfaceAt(1.5)}};
  for (const auto& pair : pairs) {
    const Clusters found(noisy(halves(pair[0], pair[1], kCamera, kWidth, kHeight)));
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
  EXPECT_NE(found.at(160, 115), found.at(40, 120));
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
  const DepthImage depth = noisy(halves(surfaceAt(1.4), surfaceAt(1.5), kCamera, kWidth, kHeight));
  Parameters parameters = adaptiveParameters(kWidth);
  ASSERT_FALSE(Clusters(depth, parameters).clusters.empty());
  parameters.clusters.min_patches = 100000;  // more than there can be, fine ones included
  const Clusters found(depth, parameters);
  EXPECT_TRUE(found.clusters.empty());
  for (const int cluster : found.cluster_of) EXPECT_EQ(cluster, -1);
}

TEST(PatchClusterer, FitsPlanesToCoarsePatchesUnlessTheyAreNarrow) {
  int narrow = 0, wide = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Clusters found(randomScene(seed, kWidth, kHeight));
    ASSERT_EQ(found.cluster_of.size(), static_cast<std::size_t>(found.levels.count()));
    std::vector<PatchCluster> coarse(found.clusters.size()), all(found.clusters.size());
    for (int i = 0; i < found.levels.count(); ++i) {
      const int k = found.cluster_of[static_cast<std::size_t>(i)];
      ASSERT_LT(k, static_cast<int>(found.clusters.size()));
      if (k < 0) continue;
      const SurfacePatch& patch = found.levels.patch(i);
      for (std::vector<PatchCluster>* sums : {&coarse, &all}) {
        if (sums == &coarse && i >= found.levels.firstFine()) continue;
        (*sums)[static_cast<std::size_t>(k)].moments += patch.moments;
        ++(*sums)[static_cast<std::size_t>(k)].patches;
      }
    }
    for (std::size_t k = 0; k < found.clusters.size(); ++k) {
      const PatchCluster& cluster = found.clusters[k];
      (cluster.is_narrow ? narrow : wide) += 1;
      const PatchCluster& expected = cluster.is_narrow ? all[k] : coarse[k];
      InverseDepthPlane plane;
      const double squared_error = expected.moments.fit(plane);
      EXPECT_EQ(cluster.patches, expected.patches);
      EXPECT_EQ(cluster.moments.pixels, expected.moments.pixels);
      EXPECT_NEAR(cluster.squared_error, squared_error, 1e-6 * (1.0 + squared_error));
      EXPECT_NEAR(cluster.plane.a, plane.a, 1e-9);
      EXPECT_NEAR(cluster.plane.b, plane.b, 1e-9);
      EXPECT_NEAR(cluster.plane.c, plane.c, 1e-9);
    }
  }
  EXPECT_GT(narrow, 10);
  EXPECT_GT(wide, 10);
}

// A strip too narrow for two coarse windows side by side, before a wall.
TEST(PatchClusterer, FindsANarrowPlaneByFinePatches) {
  const Surface strip = surfaceAt(1.2, 0.1);
  DepthImage depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
  paint(strip, kCamera, {150, 161, 0, kHeight}, depth);
  depth = noisy(depth, 0.4);
  Parameters parameters = adaptiveParameters(kWidth);
  const Clusters found(depth, parameters);
  int fine = 0;
  for (int i = found.levels.firstFine(); i < found.levels.count(); ++i) {
    const int k = found.cluster_of[static_cast<std::size_t>(i)];
    const int u = found.levels.patch(i).u;
    if (k < 0 || u < 150 || u > 160) continue;
    EXPECT_NEAR(1.0 / found.clusters[static_cast<std::size_t>(k)].plane.inverseDistance(), strip.d, 0.02);
    ++fine;
  }
  EXPECT_GT(fine, 20);

  parameters.scanlines.fine_spacing = parameters.scanlines.scanline_spacing;
  EXPECT_EQ(Clusters(depth, parameters).clusters.size() + 1, found.clusters.size());
}

TEST(PatchClusterer, CallsExplainedWhatIsInAPlane) {
  const Clusters found(noisy(halves(surfaceAt(1.4), surfaceAt(1.5), kCamera, kWidth, kHeight)));
  ASSERT_EQ(found.explained.size(), found.levels.coarse.patch_at.size());
  EXPECT_NE(found.explained[static_cast<std::size_t>(found.levels.coarse.indexAt(60, 120))], 0);
  EXPECT_EQ(found.explained[static_cast<std::size_t>(found.levels.coarse.indexAt(160, 120))], 0);
}

// A single planar patch.
TEST(PatchClusterer, LooksAtClutterMoreCloselyBesidePlanesOnly) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.5), kCamera, {156, 175, 106, 125}, depth);
  const Clusters alone(depth);
  EXPECT_GE(alone.levels.coarse.patchAt(alone.levels.coarse.indexAt(165, 115)), 0);
  EXPECT_TRUE(alone.levels.fine.patches.empty());

  paint(surfaceAt(2.0), kCamera, {0, 150, 0, kHeight}, depth);
  const Clusters beside(depth);
  int fine = 0;
  for (int i = beside.levels.firstFine(); i < beside.levels.count(); ++i)
    fine += beside.levels.patch(i).u >= 156 && beside.levels.patch(i).u < 175 ? 1 : 0;
  EXPECT_GE(fine, 4);
}

/// Part of a cylinder about the vertical, of radius 0.39 m, 1.6 m away, in the middle of the picture.
DepthImage cylinder() {
  DepthImage depth = blankDepth(kWidth, kHeight);
  const double radius = 0.39, distance = 1.99;
  for (int v = 80; v < 150; ++v) {
    for (int u = 140; u < 180; ++u) {
      const double x = kRays.x[static_cast<std::size_t>(u)];
      const double p = distance / (1.0 + x * x), q = (distance * distance - radius * radius) / (1.0 + x * x);
      depth.z[depth.index(u, v)] = static_cast<float>(p - std::sqrt(std::max(0.0, p * p - q)));
    }
  }
  return noisy(depth, 0.3);
}

TEST(PatchClusterer, TakesNoCylinderForAPlane) {
  Parameters parameters = adaptiveParameters(kWidth);
  const DepthImage depth = cylinder();
  const Clusters strict(depth, parameters);
  EXPECT_EQ(strict.at(160, 115), -1);
  parameters.clusters.max_bend = parameters.clusters.max_waviness = 1000.0;
  EXPECT_GE(Clusters(depth, parameters).at(160, 115), 0) << "it is flat enough but for its bend";
}

/// Something uneven in the middle of the picture, 1.6 m away: bent to an S, which no quadratic surface is.
DepthImage wave() {
  DepthImage depth = blankDepth(kWidth, kHeight);
  for (int v = 85; v < 145; ++v) {
    for (int u = 130; u < 190; ++u) {
      const double height = std::sin((u - 160) / 9.0);
      depth.z[depth.index(u, v)] = static_cast<float>(1.6 + 0.011 * height);
    }
  }
  return noisy(depth, 0.3);
}

TEST(PatchClusterer, TakesNoWaveForAPlane) {
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.max_curvedness = 1000.0;
  parameters.clusters.max_waviness = 0.05;
  const DepthImage depth = wave();
  const Clusters strict(depth, parameters);
  EXPECT_EQ(strict.at(160, 115), -1);
  parameters.clusters.max_waviness = 1000.0;
  EXPECT_GE(Clusters(depth, parameters).at(160, 115), 0)
      << "it is flat enough but for its waves, which are no bend";
}

TEST(PatchClusterer, TakesAFlatThingOfThatSizeForAPlane) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.6, 0.3), kCamera, {145, 175, 90, 140}, depth);
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.max_waviness = 0.05;
  EXPECT_GE(Clusters(noisy(depth, 0.3), parameters).at(160, 115), 0);
}

// Two tolerances are no step that keeps patches from merging.
TEST(PatchClusterer, PartsADoorFromTheWallThatItIsSetBackIn) {
  const Surface wall = surfaceAt(2.5, 0.2), door = surfaceAt(2.53, 0.2);
  DepthImage depth = render(wall, kCamera, kWidth, kHeight);
  paint(door, kCamera, {120, 190, 40, 210}, depth);
  const Clusters found(noisy(depth, 0.3));
  const int k_wall = found.at(40, 120), k_door = found.at(155, 120);
  ASSERT_GE(k_wall, 0);
  ASSERT_GE(k_door, 0);
  ASSERT_NE(k_wall, k_door);
  EXPECT_EQ(found.at(280, 120), k_wall);
  EXPECT_NEAR(1.0 / found.clusters[static_cast<std::size_t>(k_wall)].plane.inverseDistance(), wall.d, 0.002);
  EXPECT_NEAR(1.0 / found.clusters[static_cast<std::size_t>(k_door)].plane.inverseDistance(), door.d, 0.002);
}

// As the sensor bends it; there are outliers of its plane in the corners, but no step.
TEST(PatchClusterer, LeavesABentWallWhole) {
  DepthImage depth = render(surfaceAt(2.5), kCamera, kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double x = (u - 160.0) / 160.0, y = (v - 120.0) / 160.0;
      depth.z[depth.index(u, v)] += static_cast<float>(0.045 * (x * x + y * y));
    }
  }
  const Clusters found(noisy(depth, 0.3));
  EXPECT_EQ(found.clusters.size(), 1U);
  EXPECT_GE(std::count(found.cluster_of.begin(), found.cluster_of.begin() + found.levels.firstFine(), -1),
            12);
}

TEST(PatchClusterer, OfNothingIsNothing) {
  const Clusters found(blankDepth(kWidth, kHeight));
  EXPECT_TRUE(found.clusters.empty());
  EXPECT_EQ(found.cluster_of.size(), found.levels.coarse.patches.size());
  std::vector<PatchCluster> clusters(3);
  std::vector<int> cluster_of(3);
  std::vector<std::uint8_t> explained(3);
  PatchClusterer clusterer;
  clusterer.clusterCoarse(PatchGrid{}, adaptiveParameters(kWidth), explained);
  clusterer.cluster(blankDepth(0, 0), ViewRays{}, PatchLevels{}, adaptiveParameters(kWidth), clusters,
                    cluster_of);
  EXPECT_TRUE(explained.empty());
  EXPECT_TRUE(clusters.empty());
  EXPECT_TRUE(cluster_of.empty());
}

}  // namespace
}  // namespace line_plane_segmentation
