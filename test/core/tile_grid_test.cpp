// SPDX-License-Identifier: BSD-3-Clause
#include "planes/tile_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/row_kernels.h"
#include "planes/plane_fit.h"
#include "support/flood_fill.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

float rayAt(const std::vector<float>& rays, int pixel) { return rays[static_cast<std::size_t>(pixel)]; }

/// The pixels within `threshold` [m] of the plane that hang together with (u, v).
std::vector<std::uint8_t> inliersAt(int u, int v, const DepthImage& depth, const ViewRays& rays,
                                    const Eigen::Vector3f& normal, float d, float threshold) {
  const auto is_inlier = [&](int i, int j) {
    const float a = normal.y() * rayAt(rays.y, j) + normal.z();
    const float z = depth.at(i, j);
    return z > 0.0F && std::fabs(planeDistance(z, rayAt(rays.x, i), a, normal.x(), d)) < threshold;
  };
  return floodFill(depth.width, depth.height, u, v, is_inlier, [](int, int, int, int) { return true; });
}

/// The plane of the pixels around (u, v), or any through or near it.
Surface planeAt(int u, int v, const DepthImage& depth, const ViewRays& rays, Random& random) {
  PointMoments moments;
  for (int j = std::max(0, v - 4); j < std::min(depth.height, v + 5); ++j) {
    for (int i = std::max(0, u - 4); i < std::min(depth.width, u + 5); ++i) {
      if (depth.at(i, j) > 0.0F) moments.add(pointAt(depth, rays, i, j));
    }
  }
  PlaneFit plane;
  if (random.chance(0.7) && fitPlane(moments, plane)) return {plane.normal, plane.d};
  const Eigen::Vector3d normal = surfaceAt(1.0, random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)).normal;
  return {normal, random.uniform(-0.05, 0.05) - normal.dot(pointAt(depth, rays, u, v))};
}

bool isInSpans(int u, int v, const std::vector<TileGrid::Span>& spans) {
  return std::any_of(spans.begin(), spans.end(), [=](const TileGrid::Span& span) {
    return span.tile_row == v / TileGrid::kSide && span.first <= u && u < span.last;
  });
}

TEST(TileGrid, BoundsTheInliersOfEveryPlane) {
  TileGrid tiles;
  long pixels = 0, bounds = 0, inlier_count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const int width = random.integer(1, 130), height = random.integer(1, 100);
    DepthImage depth = randomScene(seed, width, height);
    const ViewRays rays = raysOf(kinectCamera(width, height), width, height);
    tiles.build(depth);
    for (int k = 0; k < 40; ++k) {
      const int u = random.integer(0, width - 1), v = random.integer(0, height - 1);
      const Surface surface = planeAt(u, v, depth, rays, random);
      const Eigen::Vector3f normal = surface.normal.cast<float>();
      const float d = static_cast<float>(surface.d);
      const float threshold = static_cast<float>(random.uniform(0.001, 0.05));
      const std::vector<std::uint8_t> inliers = inliersAt(u, v, depth, rays, normal, d, threshold);
      const int count = static_cast<int>(std::count(inliers.begin(), inliers.end(), 1));
      const int bound = tiles.boundInliers(rays, normal, d, threshold, u, v);
      ASSERT_GE(bound, count) << seed;
      const std::vector<TileGrid::Span> spans = tiles.spans();
      for (int i = 0; i < width * height; ++i) {
        const bool is_missed =
            inliers[static_cast<std::size_t>(i)] != 0 && !isInSpans(i % width, i / width, spans);
        ASSERT_FALSE(is_missed) << seed;
      }
      pixels += width * height;
      bounds += bound;
      inlier_count += count;
      // Pixels are taken away, as planes take theirs.
      for (int i = 0; i < width * height; ++i) {
        float& z = depth.z[static_cast<std::size_t>(i)];
        if (inliers[static_cast<std::size_t>(i)] == 0 || !random.chance(0.05)) continue;
        z = 0.0F;
        tiles.remove(i % width, i / width, 1);
      }
    }
  }
  EXPECT_GT(inlier_count, pixels / 50) << "too few inliers to test anything";
  EXPECT_LT(bounds, pixels / 2) << "a bound that bounds nothing";
}

/// 64 x 48 pixels: the left half of the tiles at 1 m, the right half at 2 m.
struct TwoWalls {
  DepthImage depth = blankDepth(64, 48);
  ViewRays rays = raysOf(kinectCamera(64, 48), 64, 48);
  TileGrid tiles;
  const Eigen::Vector3f normal{0.0F, 0.0F, -1.0F};

  TwoWalls() {
    paint(surfaceAt(1.0), kinectCamera(64, 48), {0, 32, 0, 48}, depth);
    paint(surfaceAt(2.0), kinectCamera(64, 48), {32, 64, 0, 48}, depth);
    tiles.build(depth);
  }
};

TEST(TileGrid, CountsTheTilesOfOneWallOnly) {
  TwoWalls walls;
  EXPECT_EQ(walls.tiles.boundInliers(walls.rays, walls.normal, 1.0F, 0.02F, 5, 5), 32 * 48);
  EXPECT_EQ(walls.tiles.boundInliers(walls.rays, walls.normal, 2.0F, 0.02F, 40, 5), 32 * 48);
  EXPECT_EQ(walls.tiles.boundInliers(walls.rays, walls.normal, 2.0F, 0.02F, 5, 5), 0)
      << "not this wall's plane";
  EXPECT_TRUE(walls.tiles.spans().empty());
  EXPECT_EQ(walls.tiles.boundInliers(walls.rays, walls.normal, 1.5F, 0.6F, 5, 5), 64 * 48)
      << "thick enough for both";
}

TEST(TileGrid, CountsOnlyWhatHasNotBeenTakenAway) {
  TwoWalls walls;
  walls.tiles.remove(3, 3, 100);
  EXPECT_EQ(walls.tiles.boundInliers(walls.rays, walls.normal, 1.0F, 0.02F, 5, 20), 32 * 48 - 100);
  walls.tiles.remove(3, 3, TileGrid::kSide * TileGrid::kSide - 100);
  EXPECT_EQ(walls.tiles.boundInliers(walls.rays, walls.normal, 1.0F, 0.02F, 5, 5), 0)
      << "starts in an empty tile";
}

TEST(TileGrid, ReachesTilesSideBySideOnly) {
  // Only the tiles on the diagonal have depth: they touch at corners.
  DepthImage depth = blankDepth(48, 48);
  for (int k = 0; k < 3; ++k)
    paint(surfaceAt(1.0), kinectCamera(48, 48), {16 * k, 16 * k + 16, 16 * k, 16 * k + 16}, depth);
  TileGrid tiles;
  tiles.build(depth);
  const ViewRays rays = raysOf(kinectCamera(48, 48), 48, 48);
  EXPECT_EQ(tiles.boundInliers(rays, {0.0F, 0.0F, -1.0F}, 1.0F, 0.02F, 20, 20), 256);
}

TEST(TileGrid, SpansAreStretchesOfTilesInTheImage) {
  DepthImage depth = render(surfaceAt(1.0), kinectCamera(40, 20), 40, 20);
  TileGrid tiles;
  tiles.build(depth);
  tiles.boundInliers(raysOf(kinectCamera(40, 20), 40, 20), {0.0F, 0.0F, -1.0F}, 1.0F, 0.02F, 0, 0);
  const std::vector<TileGrid::Span>& spans = tiles.spans();
  ASSERT_EQ(spans.size(), 2U);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(spans[row].tile_row, static_cast<int>(row));
    EXPECT_EQ(spans[row].first, 0);
    EXPECT_EQ(spans[row].last, 40);
  }
}

TEST(TileGrid, OfNoDepthBoundsNothing) {
  TileGrid tiles;
  tiles.build(blankDepth(20, 20));
  EXPECT_EQ(tiles.boundInliers(raysOf(kinectCamera(20, 20), 20, 20), {0.0F, 0.0F, -1.0F}, 1.0F, 1.0F, 3, 3),
            0);
}

}  // namespace
}  // namespace line_plane_segmentation
