// SPDX-License-Identifier: BSD-3-Clause
// The limits within which clusters of candidates are planes, narrow, or parts of one plane; the rest of
// plane_clustering.h is tested in plane_clustering_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "planes/plane_clustering.h"
#include "support/clustered_image.h"
#include "support/made_candidates.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr int kSpacing = 10;  // [px] of scanlines at this width
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

/// The pixels around `columns` times `rows` crossings of scanlines.
Region regionOf(int columns, int rows) { return {50, 50 + columns * kSpacing, 10, 10 + rows * kSpacing}; }

bool isNarrow(int columns, int rows) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.5), kCamera, regionOf(columns, rows), depth);
  const ClusteredImage image(depth, adaptiveParameters(kWidth));
  EXPECT_EQ(image.clusters.size(), 1U);
  EXPECT_EQ(image.clusters.at(0).candidates, columns * rows);
  return image.clusters.at(0).is_narrow;
}

TEST(NarrowPlanes, SpanFewerThanThreeScanlines) {
  EXPECT_FALSE(isNarrow(4, 20));
  EXPECT_TRUE(isNarrow(2, 20));
}

TEST(NarrowPlanes, HaveFewerThan28Candidates) {
  EXPECT_FALSE(isNarrow(6, 6));
  EXPECT_TRUE(isNarrow(5, 5));
}

/// Whether a plane is narrow whose rows of candidates each begin one column further to the right.
bool isSlantedNarrow(int candidates_per_row) {
  constexpr int kRows = 20;
  MadeCandidates made(kRows + candidates_per_row - 1, kRows);
  for (int row = 0; row < kRows; ++row) {
    for (int column = row; column < row + candidates_per_row; ++column) {
      made.add(column, row, 0.0);
      if (column > row) made.link(column - 1, row, column, row);
      if (row > 0 && column + 1 < row + candidates_per_row) made.link(column, row - 1, column, row);
    }
  }
  std::vector<PlaneCluster> clusters;
  std::vector<int> cluster_at;
  PlaneClusterer().cluster(blankDepth(0, 0), {}, made, adaptiveParameters(kWidth), 1.0, clusters, cluster_at);
  EXPECT_EQ(clusters.size(), 1U);
  return clusters.at(0).is_narrow;
}

TEST(NarrowPlanes, FillFewerThanThreeTimesTheScanlinesThatTheySpan) {
  EXPECT_TRUE(isSlantedNarrow(3));
  EXPECT_FALSE(isSlantedNarrow(4));
}

/// Parameters by which everything is one cluster, which is a plane unless its bend is too large.
Parameters parametersOfOneCluster() {
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.clusters.merge_cost = parameters.patches.patch_flatness = 100.0;
  parameters.clusters.max_curvedness = parameters.clusters.max_waviness = 1000.0;
  return parameters;
}

/// A wall 1.5 m away in a region, moved by height_at(column, row) [m], which are in scanlines from its
/// middle.
template <typename HeightAt>
DepthImage wallWith(const Region& region, HeightAt&& height_at) {
  DepthImage depth = blankDepth(kWidth, kHeight);
  paint(surfaceAt(1.5), kCamera, region, depth);
  for (int v = region.first_v; v < region.last_v; ++v) {
    for (int u = region.first_u; u < region.last_u; ++u)
      depth.row(v)[u] +=
          static_cast<float>(height_at((u - 0.5 * (region.first_u + region.last_u - 1)) / kSpacing,
                                       (v - 0.5 * (region.first_v + region.last_v - 1)) / kSpacing));
  }
  return depth;
}

/// The variance of candidates about the plane of the only cluster [tolerance²].
double varianceOf(const ClusteredImage& image) {
  EXPECT_EQ(image.clusters.size(), 1U);
  const PlaneCluster& cluster = image.clusters.at(0);
  InverseDepthPlane plane;
  double squared_error = 0.0;
  EXPECT_TRUE(cluster.means.fit(plane, squared_error));
  return squared_error / (cluster.candidates - 3);
}

/// Whether a region that bends like a bowl is a plane.
bool isPlane(int columns, int rows, double height) {
  Parameters parameters = parametersOfOneCluster();
  parameters.clusters.max_bend = 0.1;
  const auto bowl = [height](double x, double y) { return height * (x * x + y * y); };
  return !ClusteredImage(wallWith(regionOf(columns, rows), bowl), parameters).clusters.empty();
}

TEST(CurvedSurfaces, AreDetectedFromEightCandidatesOn) {
  EXPECT_TRUE(isPlane(2, 3, 0.004))
      << "the deviations are larger, but six candidates fit any quadric surface";
  EXPECT_FALSE(isPlane(3, 4, 0.002));
}

/// Whether a bowl with waves is a plane, if a quadric surface leaves `fraction` of its variance.
bool isPlaneWithResidual(double fraction) {
  Parameters parameters = parametersOfOneCluster();
  parameters.clusters.max_bend = 1000.0;
  const auto image_of = [&parameters](double bowl, double waves) {
    const auto height_at = [=](double x, double y) {
      return bowl * (x * x + y * y) + waves * std::sin(1.6 * x) * std::sin(1.6 * y);
    };
    return ClusteredImage(wallWith(regionOf(10, 10), height_at), parameters);
  };
  constexpr double kBowl = 0.0003, kWaves = 0.002;
  const double of_bowl = varianceOf(image_of(kBowl, 0.0)), of_waves = varianceOf(image_of(0.0, kWaves));
  const double waves = kWaves * std::sqrt(fraction / (1.0 - fraction) * of_bowl / of_waves);
  parameters.clusters.max_bend = 0.001;
  return !image_of(kBowl, waves).clusters.empty();
}

TEST(CurvedSurfaces, AreExplainedByAQuadricButForAQuarter) {
  EXPECT_FALSE(isPlaneWithResidual(0.18));
  EXPECT_TRUE(isPlaneWithResidual(0.35));
}

// A plane of 0.047 of the image may have twice the waviness of a small one.
TEST(Distortion, DoublesTheBoundsAt45ThousandthsOfTheImage) {
  const DepthImage depth = wallWith(
      regionOf(6, 6), [](double x, double y) { return 0.002 * std::sin(1.6 * x) * std::sin(1.6 * y); });
  Parameters parameters = parametersOfOneCluster();
  parameters.clusters.max_bend = 1000.0;
  const double variance = varianceOf(ClusteredImage(depth, parameters));
  parameters.clusters.max_waviness = variance / 1.6;
  EXPECT_EQ(ClusteredImage(depth, parameters).clusters.size(), 1U);
  parameters.clusters.max_waviness = variance / 2.8;
  EXPECT_EQ(ClusteredImage(depth, parameters).clusters.size(), 0U);
}

/// Whether the flat columns of twelve are a plane, the others being rough.
bool isFlatPartFound(int flat_columns) {
  Parameters parameters = parametersOfOneCluster();
  parameters.clusters.merge_cost = Parameters{}.clusters.merge_cost;  // so that the flat part grows first
  parameters.extraction.min_plane_inliers = 15 * kSpacing * kSpacing;
  const auto height_at = [flat_columns](double x, double y) {
    return x + 6.0 < flat_columns ? 0.0 : 0.004 * std::sin(1.6 * x) * std::sin(1.6 * y);
  };
  const DepthImage depth = wallWith(regionOf(12, 6), height_at);
  EXPECT_EQ(ClusteredImage(depth, parameters).clusters.size(), 1U);
  parameters.clusters.max_waviness = 0.002;
  return !ClusteredImage(depth, parameters).clusters.empty();
}

TEST(Parts, ArePlanesIfTheyAreMostOfACluster) {
  EXPECT_TRUE(isFlatPartFound(8));
  EXPECT_FALSE(isFlatPartFound(4));
}

/// Two parts of a wall and a strip between them.
/// @param behind    [m] distance of the strip behind the wall; the rest of the strip is nearer than the wall
/// @param fraction  of the pixels between the parts that are behind the wall
/// @return whether the parts are one plane
bool areOnePlane(double distance, double behind, double fraction) {
  DepthImage depth = render(surfaceAt(distance), kCamera, kWidth, kHeight);
  const int first = 120, last = 200,
            middle = first + static_cast<int>(std::lround(fraction * (last - first)));
  paint(surfaceAt(distance + behind), kCamera, {first, middle, 0, kHeight}, depth);
  paint(surfaceAt(0.7 * distance), kCamera, {middle, last, 0, kHeight}, depth);
  const ClusteredImage image(depth, adaptiveParameters(kWidth));
  EXPECT_GE(image.at(40, 120), 0);
  return image.at(40, 120) == image.at(280, 120);
}

TEST(CoplanarParts, AreOnePlaneIfLessThanAQuarterBetweenThemIsBehind) {
  EXPECT_TRUE(areOnePlane(1.5, 1.5, 0.18));
  EXPECT_FALSE(areOnePlane(1.5, 1.5, 0.35));
}

/// Two strips of a wall with something nearer between them.
/// @param columns  scanlines across each strip
/// @param behind   [m] distance of the second strip behind the first
bool areStripsOnePlane(int columns, double behind) {
  const int width = columns * kSpacing;
  DepthImage depth = render(surfaceAt(1.0), kCamera, kWidth, kHeight);
  paint(surfaceAt(1.5), kCamera, {100 - width, 100, 0, kHeight}, depth);
  paint(surfaceAt(1.5 + behind), kCamera, {160, 160 + width, 0, kHeight}, depth);
  const ClusteredImage image(depth, adaptiveParameters(kWidth));
  EXPECT_GE(image.at(95, 120), 0);
  return image.at(95, 120) == image.at(165, 120);
}

TEST(CoplanarParts, AreAtOneDepthHoweverNarrow) {
  for (const int columns : {2, 3}) {
    EXPECT_TRUE(areStripsOnePlane(columns, 0.0)) << columns;
    EXPECT_FALSE(areStripsOnePlane(columns, 0.03)) << columns;
  }
}

/// The plane of inverse depth rho whose slopes are a and b at the ray (x, y).
Surface planeThrough(double x, double y, double rho, double a, double b) {
  const Eigen::Vector3d coefficients(a, b, rho - a * x - b * y);
  return {-coefficients.normalized(), 1.0 / coefficients.norm()};
}

// The planes of both parts meet halfway, at 10 degrees.
TEST(CoplanarParts, AreAtOneDepthHalfwayBetweenThem) {
  constexpr double kSlope = 0.06, kRho = 1.0 / 1.5;
  const double x = (80.0 - kCamera.cx) / kCamera.fx, y = (80.0 - kCamera.cy) / kCamera.fy;
  DepthImage depth = render(surfaceAt(1.0), kCamera, kWidth, kHeight);
  paint(planeThrough(x, y, kRho, kSlope, 0.0), kCamera, {10, 60, 0, kHeight}, depth);
  paint(planeThrough(x, y, kRho, -kSlope, 0.0), kCamera, {100, 150, 0, kHeight}, depth);
  const ClusteredImage beside(depth, adaptiveParameters(kWidth));
  EXPECT_GE(beside.at(55, 120), 0);
  EXPECT_EQ(beside.at(55, 120), beside.at(105, 120));

  depth = render(surfaceAt(1.0), kCamera, kWidth, kHeight);
  paint(planeThrough(x, y, kRho, 0.0, kSlope), kCamera, {0, kWidth, 10, 60}, depth);
  paint(planeThrough(x, y, kRho, 0.0, -kSlope), kCamera, {0, kWidth, 100, 150}, depth);
  const ClusteredImage below(depth, adaptiveParameters(kWidth));
  EXPECT_GE(below.at(160, 55), 0);
  EXPECT_EQ(below.at(160, 55), below.at(160, 105));
}

// A pixel is behind the plane if its distance is more than twice that of the pixels of the plane.
TEST(CoplanarParts, HaveNothingBehindWithinTwiceTheTolerance) {
  const Parameters p = adaptiveParameters(kWidth);
  const double near = 0.7, by_distance = p.extraction.plane_distance;
  EXPECT_TRUE(areOnePlane(near, 1.5 * by_distance, 0.5));
  EXPECT_FALSE(areOnePlane(near, 2.7 * by_distance, 0.5));
  const double far = 4.0, by_noise = p.extraction.distance_noise_factor * p.noise.sigma(far);
  EXPECT_TRUE(areOnePlane(far, 1.5 * by_noise, 0.5));
  EXPECT_FALSE(areOnePlane(far, 2.7 * by_noise, 0.5));
}

}  // namespace
}  // namespace line_plane_segmentation
