// SPDX-License-Identifier: BSD-3-Clause
#include "refine/region_cleanup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/clustered_image.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 60, kHeight = 40;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);
const ViewRays kRays = raysOf(kCamera, kWidth, kHeight);

/// Two walls that meet in the middle of the image, and a label image to be cleaned.
struct TwoWalls {
  const Surface left = surfaceAt(1.5, 0.3), right = surfaceAt(1.5, -0.3);
  const std::vector<PlaneCluster> clusters = {clusterOf(left), clusterOf(right), clusterOf(surfaceAt(9.0))};
  DepthImage depth = blankDepth(kWidth, kHeight);
  std::vector<std::uint16_t> labels = std::vector<std::uint16_t>(kWidth * kHeight, 0);
  Parameters parameters = adaptiveParameters(kWidth);
  RegionCleaner cleaner;

  TwoWalls() {
    parameters.cleanup.min_region_pixels = 20;
    parameters.extraction.min_plane_inliers = 100;
    paint(left, kCamera, {0, 30, 0, kHeight}, depth);
    paint(right, kCamera, {30, kWidth, 0, kHeight}, depth);
    label(1, {0, 30, 0, kHeight});
    label(2, {30, kWidth, 0, kHeight});
  }

  void label(std::uint16_t value, const Region& region) {
    for (int v = region.first_v; v < region.last_v; ++v) {
      for (int u = region.first_u; u < region.last_u; ++u) labels[depth.index(u, v)] = value;
    }
  }
  std::uint16_t at(int u, int v) const { return labels[depth.index(u, v)]; }
  std::ptrdiff_t pixelsOf(std::uint16_t value) const {
    return std::count(labels.begin(), labels.end(), value);
  }

  int clean() {
    LabelRuns runs;
    runs.scan(labels, kWidth, kHeight);
    const int planes = cleaner.clean(depth, kRays, clusters, parameters, runs);
    for (std::size_t i = 1; i < runs.runs.size(); ++i) {
      EXPECT_FALSE(runs.runs[i].row == runs.runs[i - 1].row && runs.runs[i].label == runs.runs[i - 1].label)
          << "runs are joined";
    }
    labels.clear();
    for (const LabelRun& run : runs.runs)
      labels.insert(labels.end(), static_cast<std::size_t>(run.pixels()), run.label);
    return planes;
  }
};

TEST(RegionCleaner, LeavesACleanImage) {
  TwoWalls walls;
  const std::vector<std::uint16_t> before = walls.labels;
  EXPECT_EQ(walls.clean(), 2);
  EXPECT_EQ(walls.labels, before);
}

TEST(RegionCleaner, GivesSmallPiecesToThePlaneAroundThem) {
  TwoWalls walls;
  walls.label(0, {5, 9, 5, 9});      // no plane, 16 pixels
  walls.label(2, {12, 15, 20, 24});  // of the other plane
  walls.label(3, {40, 44, 10, 13});  // of a plane that is nowhere else
  walls.label(0, {0, 3, 0, 3});      // in a corner of the image
  EXPECT_EQ(walls.clean(), 2);
  EXPECT_EQ(walls.pixelsOf(1), 30 * kHeight);
  EXPECT_EQ(walls.pixelsOf(2), 30 * kHeight);
}

TEST(RegionCleaner, LeavesLargePieces) {
  TwoWalls walls;
  walls.label(2, {5, 10, 5, 9});     // 20 pixels: as many as it takes
  walls.label(0, {5, 10, 20, 24});   // 20 pixels of no plane
  walls.label(0, {18, 23, 10, 13});  // 15 pixels
  walls.clean();
  EXPECT_EQ(walls.at(7, 7), walls.at(50, 7));
  EXPECT_EQ(walls.pixelsOf(0), 20);
  EXPECT_EQ(walls.at(7, 22), 0);
}

// A box on a table lies near its plane, but one sees where it begins.
TEST(RegionCleaner, LeavesWhatStandsOutByAStep) {
  TwoWalls walls;
  const Region box = {5, 15, 5, 15};
  const float step = 0.02F;
  for (int v = box.first_v; v < box.last_v; ++v) {
    for (int u = box.first_u; u < box.last_u; ++u) walls.depth.z[walls.depth.index(u, v)] -= step;
  }
  walls.label(0, box);
  walls.parameters.extraction.plane_distance = 0.015;
  walls.parameters.extraction.distance_noise_factor = 4.0;
  const double noise = 4.0 * walls.parameters.noise.sigma(1.5);
  ASSERT_GT(step, noise) << "a step that noise does not make";
  ASSERT_LT(step, 2.0 * noise) << "and near enough to the wall to be taken for it";
  walls.clean();
  EXPECT_EQ(walls.pixelsOf(0), 100);
}

TEST(RegionCleaner, FillsAGapWhereAPlaneBends) {
  TwoWalls walls;
  walls.parameters.cleanup.min_region_pixels = 101;
  const Region corner = {0, 10, 0, 10};
  for (int v = corner.first_v; v < corner.last_v; ++v) {
    for (int u = corner.first_u; u < corner.last_u; ++u) {
      walls.depth.z[walls.depth.index(u, v)] += 0.002F * static_cast<float>(10 - u);  // 2 cm at the border
    }
  }
  walls.label(0, corner);
  walls.clean();
  EXPECT_EQ(walls.pixelsOf(0), 0);
}

TEST(RegionCleaner, CountsAPieceByWhatHangsTogether) {
  TwoWalls walls;
  walls.label(2, {5, 9, 5, 9});      // 16 pixels
  walls.label(2, {9, 13, 9, 13});    // 16 more, that touch them at a corner only
  walls.label(2, {18, 22, 20, 24});  // 16 pixels
  walls.label(2, {20, 24, 24, 26});  // 8 more, below them
  walls.clean();
  EXPECT_EQ(walls.at(6, 6), walls.at(2, 30));
  EXPECT_EQ(walls.at(10, 10), walls.at(2, 30));
  EXPECT_EQ(walls.at(19, 21), walls.at(50, 30));
  EXPECT_EQ(walls.at(23, 25), walls.at(50, 30));
}

TEST(RegionCleaner, LeavesWhatLiesOffThePlaneAroundIt) {
  TwoWalls walls;
  paint(surfaceAt(1.2), kCamera, {5, 9, 5, 9}, walls.depth);
  walls.label(0, {5, 9, 5, 9});
  walls.label(3, {12, 15, 5, 9});
  paint(surfaceAt(1.2), kCamera, {12, 15, 5, 9}, walls.depth);
  walls.clean();
  EXPECT_EQ(walls.pixelsOf(0), 16 + 12);
  EXPECT_EQ(walls.at(6, 6), 0);
  EXPECT_EQ(walls.at(13, 6), 0) << "its own plane is no plane, and the one around it is not its";
}

// A bump in the wall whose foot is no step: all of its border touches the wall.
TEST(RegionCleaner, LeavesWhatRisesFromThePlaneWithoutAStep) {
  const Region box = {5, 25, 5, 12};
  const auto pixels_in_no_plane = [&box](double height) {
    TwoWalls walls;
    walls.parameters.extraction.plane_distance = 0.0;
    walls.parameters.cleanup.min_region_pixels = 141;
    for (int v = box.first_v; v < box.last_v; ++v) {
      const bool is_foot = v == box.first_v || v + 1 == box.last_v;
      for (int u = box.first_u; u < box.last_u; ++u) {
        float& z = walls.depth.z[walls.depth.index(u, v)];
        const double noise = walls.parameters.extraction.distance_noise_factor *
                             walls.parameters.noise.sigma(static_cast<double>(z));
        z -= static_cast<float>((is_foot ? 0.8 : height) * noise);
      }
    }
    walls.label(0, box);
    walls.clean();
    return walls.pixelsOf(0);
  };
  EXPECT_EQ(pixels_in_no_plane(1.6), 0);
  EXPECT_EQ(pixels_in_no_plane(4.0), 140) << "more than twice the tolerance on average";
}

TEST(RegionCleaner, GivesAPieceBetweenTwoPlanesToTheOneThatHoldsMostOfItsBorder) {
  TwoWalls walls;
  walls.label(0, {28, 31, 10, 14});  // two columns of it on the left wall, one on the right
  walls.clean();
  EXPECT_EQ(walls.at(28, 12), 1);
  EXPECT_EQ(walls.at(30, 12), 1);
  TwoWalls halved;
  halved.label(0, {28, 32, 10, 14});  // no majority
  halved.clean();
  EXPECT_EQ(halved.at(28, 12), 0);
  EXPECT_EQ(halved.at(31, 12), 0);
}

TEST(RegionCleaner, TouchesNoPixelWithoutDepth) {
  TwoWalls walls;
  walls.label(kNoDepthLabel, {5, 8, 5, 8});
  walls.label(kNoDepthLabel, {0, kWidth, 20, 21});
  walls.clean();
  EXPECT_EQ(walls.pixelsOf(0), 9 + kWidth);
  EXPECT_EQ(walls.at(6, 6), 0);
}

TEST(RegionCleaner, DropsSmallPlanesAndNumbersTheOthersByTheirSize) {
  TwoWalls walls;
  walls.label(3, {35, 45, 0, 10});  // 100 pixels: just a plane
  walls.label(2, {20, 30, 0, kHeight});
  EXPECT_EQ(walls.clean(), 3);
  EXPECT_EQ(walls.at(50, 30), 1) << "the right wall is the larger one now";
  EXPECT_EQ(walls.at(10, 30), 2);
  EXPECT_EQ(walls.at(40, 5), 3);
  EXPECT_EQ(walls.cleaner.clusterOf(1), 1);
  EXPECT_EQ(walls.cleaner.clusterOf(2), 0);
  EXPECT_EQ(walls.cleaner.clusterOf(3), 2);

  TwoWalls smaller;
  smaller.label(3, {35, 45, 0, 10});
  smaller.parameters.extraction.min_plane_inliers = 101;
  EXPECT_EQ(smaller.clean(), 2);
  EXPECT_EQ(smaller.at(40, 5), 0);
}

TEST(RegionCleaner, KeepsTheOrderOfEqualPlanes) {
  TwoWalls walls;
  EXPECT_EQ(walls.clean(), 2);
  EXPECT_EQ(walls.at(10, 10), 1);
  EXPECT_EQ(walls.at(50, 10), 2);
}

TEST(RegionCleaner, OfNothingIsNothing) {
  TwoWalls walls;
  walls.label(0, {0, kWidth, 0, kHeight});
  EXPECT_EQ(walls.clean(), 0);
  EXPECT_EQ(walls.pixelsOf(0), kWidth * kHeight);
  walls.label(kNoDepthLabel, {0, kWidth, 0, kHeight});
  EXPECT_EQ(walls.clean(), 0);
  LabelRuns empty;
  empty.clear();
  EXPECT_EQ(RegionCleaner().clean(blankDepth(0, 0), ViewRays{}, {}, walls.parameters, empty), 0);
}

}  // namespace
}  // namespace line_plane_segmentation
