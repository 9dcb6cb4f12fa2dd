// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_clustering.h"

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

TEST(PlaneClusterer, MakesOneClusterOfOnePlane) {
  const Surface surface = surfaceAt(2.0, 0.5, -0.3);
  const Clusters found(noisy(render(surface, kCamera, kWidth, kHeight)));
  ASSERT_EQ(found.clusters.size(), 1U);
  EXPECT_TRUE(found.isAt(160, 120, surface));
  EXPECT_TRUE(found.isAt(40, 200, surface));
  EXPECT_GT(found.clusters[0].candidates, 0.85 * found.grid.crossings());
}

TEST(PlaneClusterer, SplitsPlanesAtACreaseAndAtAStep) {
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

TEST(PlaneClusterer, MergesWhatANearerSurfaceOccludes) {
  const Surface table = surfaceAt(1.5, 0.0, -0.5);
  const Clusters found(cutTable(table, surfaceAt(1.0)));
  EXPECT_GE(found.at(40, 120), 0);
  EXPECT_EQ(found.at(40, 120), found.at(280, 120));
  EXPECT_TRUE(found.isAt(40, 120, table));
  EXPECT_NE(found.at(160, 115), found.at(40, 120));
}

TEST(PlaneClusterer, SeparatesPlanesWithOpenSpaceBetween) {
  const Surface table = surfaceAt(1.5, 0.0, -0.5);
  const Clusters found(cutTable(table, surfaceAt(3.0)));
  EXPECT_GE(found.at(40, 120), 0);
  EXPECT_GE(found.at(280, 120), 0);
  EXPECT_NE(found.at(40, 120), found.at(280, 120));
}

TEST(PlaneClusterer, SeparatesOccludedPlanesAtDifferentDepths) {
  for (const double metres : {0.012, 0.03}) {
    DepthImage depth = halves(surfaceAt(1.5), surfaceAt(1.5 + metres), kCamera, kWidth, kHeight);
    paint(surfaceAt(1.0), kCamera, {130, 190, 0, kHeight}, depth);
    const Clusters found(noisy(depth));
    const bool is_one = found.at(40, 120) == found.at(280, 120);
    EXPECT_EQ(is_one, metres < adaptiveParameters(kWidth).extraction.plane_distance) << metres;
  }
}

TEST(PlaneClusterer, MergesNothingCoplanarAtCostZero) {
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.coplanar_cost = 0.0;
  const Clusters found(cutTable(surfaceAt(1.5, 0.0, -0.5), surfaceAt(1.0)), parameters);
  EXPECT_NE(found.at(40, 120), found.at(280, 120));
}

TEST(PlaneClusterer, DropsClustersOfTooFewCandidates) {
  const DepthImage depth = noisy(halves(surfaceAt(1.4), surfaceAt(1.5), kCamera, kWidth, kHeight));
  Parameters parameters = adaptiveParameters(kWidth);
  ASSERT_FALSE(Clusters(depth, parameters).clusters.empty());
  parameters.clusters.min_patches = 100000;  // more than there can be
  const Clusters found(depth, parameters);
  EXPECT_TRUE(found.clusters.empty());
  for (const int cluster : found.cluster_at) EXPECT_EQ(cluster, -1);
}

TEST(PlaneClusterer, JoinsPartsOfTooFewCandidatesBeforeItDropsThem) {
  const Surface wall = surfaceAt(1.6), bars = surfaceAt(1.2);
  DepthImage depth = render(wall, kCamera, kWidth, kHeight);
  for (int u = 30; u + 20 <= kWidth; u += 50) paint(bars, kCamera, {u, u + 20, 0, kHeight}, depth);
  for (int v = 30; v + 20 <= kHeight; v += 50) paint(bars, kCamera, {0, kWidth, v, v + 20}, depth);
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.min_patches = 20;  // an opening has room for nine crossings
  const Clusters found(noisy(depth, 0.3), parameters);
  for (int u = 65; u < kWidth - 30; u += 50) {
    EXPECT_TRUE(found.isAt(u, 115, wall)) << u;
    EXPECT_EQ(found.at(u, 115), found.at(65, 115)) << u;
  }
}

TEST(PlaneClusterer, FindsAPlaneNarrowerThanTwoScanlineSpacings) {
  const Surface strip = surfaceAt(1.2, 0.1);
  DepthImage depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
  paint(strip, kCamera, {150, 168, 0, kHeight}, depth);
  const Clusters found(noisy(depth, 0.4));
  int in_strip = 0;
  for (std::size_t i = 0; i < found.grid.candidates.size(); ++i) {
    const CrossingCandidate& candidate = found.grid.candidates[i];
    const int k = found.clusterOf(i);
    if (k < 0 || candidate.u < 150 || candidate.u >= 168) continue;
    EXPECT_NEAR(1.0 / found.clusters[static_cast<std::size_t>(k)].plane.inverseDistance(), strip.d, 0.02);
    ++in_strip;
  }
  EXPECT_GT(in_strip, 15);
}

// A wall and a floor on which a rough object stands: the wrong merge of one part does not lose the other.
TEST(PlaneClusterer, KeepsThePlanesOfAClusterThatIsNone) {
  DepthImage depth = halves(surfaceAt(1.8, 0.1), surfaceAt(1.8, -0.1), kCamera, kWidth, kHeight);
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.merge_cost = 1000.0;
  const Clusters found(noisy(depth), parameters);
  EXPECT_EQ(found.clusters.size(), 2U);
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

TEST(PlaneClusterer, RejectsACylinder) {
  Parameters parameters = adaptiveParameters(kWidth);
  const DepthImage depth = cylinder();
  const Clusters strict(depth, parameters);
  EXPECT_EQ(strict.at(160, 115), -1);
  parameters.clusters.max_bend = parameters.clusters.max_waviness = 1000.0;
  EXPECT_GE(Clusters(depth, parameters).at(160, 115), 0) << "it is flat enough but for its bend";
}

/// A round pillar, 1.8 m away, in front of a wall.
DepthImage pillar(double radius) {
  DepthImage depth = render(surfaceAt(4.0), kCamera, kWidth, kHeight);
  const double distance = 1.8 + radius;
  for (int u = 0; u < kWidth; ++u) {
    const double x = kRays.x[static_cast<std::size_t>(u)];
    const double p = distance / (1.0 + x * x), q = (distance * distance - radius * radius) / (1.0 + x * x);
    if (p * p < q) continue;
    for (int v = 0; v < kHeight; ++v) depth.row(v)[u] = static_cast<float>(p - std::sqrt(p * p - q));
  }
  return noisy(depth, 1.0);
}

// It falls apart into strips, some of which are flat enough for so large a share of the image.
TEST(PlaneClusterer, FindsNoPlaneOnAPillar) {
  for (const double radius : {0.15, 0.25}) {
    const Clusters found(pillar(radius));
    EXPECT_GE(found.at(20, 120), 0) << "the wall";
    // Seen from the side, the last columns are too narrow to be judged.
    const int half_width = static_cast<int>(0.5 * kCamera.fx * radius / (1.8 + radius));
    for (int u = 160 - half_width; u < 160 + half_width; ++u) EXPECT_EQ(found.at(u, 120), -1) << u;
  }
}

/// A dimpled surface in the middle of the image, 1.6 m away, which no quadric surface and no few planes are.
DepthImage wave() {
  DepthImage depth = blankDepth(kWidth, kHeight);
  for (int v = 85; v < 145; ++v) {
    for (int u = 130; u < 190; ++u) {
      const double height = std::sin((u - 160) / 9.0) * std::sin((v - 115) / 9.0);
      depth.z[depth.index(u, v)] = static_cast<float>(1.6 + 0.011 * height);
    }
  }
  return noisy(depth, 0.3);
}

TEST(PlaneClusterer, RejectsAWave) {
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

TEST(PlaneClusterer, AcceptsAFlatSurfaceOfThatSize) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.6, 0.3), kCamera, {145, 175, 90, 140}, depth);
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.max_waviness = 0.05;
  EXPECT_GE(Clusters(noisy(depth, 0.3), parameters).at(160, 115), 0);
}

// As the sensor's distortion bends it.
TEST(PlaneClusterer, KeepsABentWallWhole) {
  DepthImage depth = render(surfaceAt(2.5), kCamera, kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double x = (u - 160.0) / 160.0, y = (v - 120.0) / 160.0;
      depth.z[depth.index(u, v)] += static_cast<float>(0.045 * (x * x + y * y));
    }
  }
  EXPECT_EQ(Clusters(noisy(depth, 0.3)).clusters.size(), 1U);
}

TEST(PlaneClusterer, OfNothingIsNothing) {
  const Clusters found(blankDepth(kWidth, kHeight));
  EXPECT_TRUE(found.clusters.empty());
  EXPECT_FALSE(found.cluster_at.empty());
  for (const int cluster : found.cluster_at) EXPECT_EQ(cluster, -1);
  std::vector<PlaneCluster> clusters(3);
  std::vector<int> cluster_at(3);
  PlaneClusterer().cluster(blankDepth(0, 0), ViewRays{}, CandidateGrid{}, adaptiveParameters(kWidth), 1.0,
                           clusters, cluster_at);
  EXPECT_TRUE(clusters.empty());
  EXPECT_TRUE(cluster_at.empty());
}

}  // namespace
}  // namespace line_plane_segmentation
