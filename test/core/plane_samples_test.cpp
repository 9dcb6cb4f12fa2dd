// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/plane_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

// Tiles of some pixels, each a plane of its own that faces the camera; every seventh tile has no label.
Segmentation tiles(int side) {
  Segmentation image;
  image.width = kWidth;
  image.height = kHeight;
  image.labels.resize(std::size_t{kWidth} * kHeight);
  const int columns = (kWidth + side - 1) / side;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const int tile = v / side * columns + u / side;
      const std::size_t pixel = static_cast<std::size_t>(v) * kWidth + static_cast<std::size_t>(u);
      image.labels[pixel] = static_cast<std::uint16_t>(tile % 7 == 6 ? 0 : tile + 1);
    }
  }
  for (int k = 0; k < columns * ((kHeight + side - 1) / side); ++k) {
    SegmentedPlane plane;
    plane.label = static_cast<std::uint16_t>(k + 1);
    plane.normal = -Eigen::Vector3d::UnitZ();
    plane.d = 1.0 + 0.001 * k;
    image.planes.push_back(plane);
  }
  return image;
}

// Every pair of owner and plane, counted in a full matrix.
TEST(VoteTable, holdsWhatAFullMatrixHolds) {
  const CameraIntrinsics camera = kinectCamera(kWidth, kHeight);
  for (const int side : {3, 10, 50}) {
    const Segmentation image = tiles(side);
    Random random(static_cast<std::uint64_t>(side));
    std::vector<PlaneSample> samples;
    constexpr int kOwners = 40;
    for (int i = 0; i < 3000; ++i) {
      const double z = random.uniform(-0.5, 4.0);
      samples.push_back(
          {Eigen::Vector3d(z * random.uniform(-0.8, 0.8), z * random.uniform(-0.6, 0.6), z).cast<float>(),
           static_cast<int>(random.uniform(0.0, kOwners - 1.0))});
    }
    std::map<std::pair<int, int>, std::pair<int, double>> expected;
    std::vector<int> in_view(kOwners, 0);
    for (const PlaneSample& sample : samples) {
      if (sample.point.z() < 0.01F) continue;
      const int u =
          static_cast<int>(std::floor(camera.fx * sample.point.x() / sample.point.z() + camera.cx + 0.5));
      const int v =
          static_cast<int>(std::floor(camera.fy * sample.point.y() / sample.point.z() + camera.cy + 0.5));
      if (u < 0 || u >= kWidth || v < 0 || v >= kHeight) continue;
      ++in_view[static_cast<std::size_t>(sample.owner)];
      const int label = image.labels[static_cast<std::size_t>(v) * kWidth + static_cast<std::size_t>(u)];
      if (label == 0) continue;
      auto& [count, distance] = expected[{sample.owner, label - 1}];
      ++count;
      distance +=
          std::abs(image.planes[static_cast<std::size_t>(label) - 1].d - sample.point.z()) / sample.point.z();
    }

    VoteTable votes;
    votes.count(samples, kOwners, image, camera);
    std::size_t pairs = 0;
    for (int owner = 0; owner < kOwners; ++owner) {
      const auto o = static_cast<std::size_t>(owner);
      EXPECT_EQ(in_view[o], votes.inView(o));
      for (const SampleVotes* shared = votes.begin(o); shared != votes.end(o); ++shared, ++pairs) {
        const auto [count, distance] = expected[{owner, shared->plane}];
        EXPECT_EQ(count, shared->samples) << "owner " << owner << ", plane " << shared->plane;
        EXPECT_NEAR(distance, shared->distance, 1e-4 * (1.0 + distance));
      }
    }
    EXPECT_EQ(expected.size(), pairs);
    EXPECT_GT(pairs, 100U);
  }
}

TEST(VoteTable, isEmptyWithoutSamples) {
  VoteTable votes;
  votes.count({}, 2, tiles(10), kinectCamera(kWidth, kHeight));
  EXPECT_EQ(votes.begin(1), votes.end(1));
  EXPECT_EQ(0, votes.inView(0));
}

TEST(VoteTable, countsPointsMoreThanACentimetreAhead) {
  const auto in_view = [](float z) {
    VoteTable votes;
    votes.count({{{0.0F, 0.0F, z}, 0}}, 1, tiles(10), kinectCamera(kWidth, kHeight));
    return votes.inView(0);
  };
  EXPECT_EQ(0, in_view(0.007F));
  EXPECT_EQ(1, in_view(0.014F));
}

/// The samples of an image of one plane.
std::vector<PlaneSample> samplesOf(int width, int height, const CameraIntrinsics& camera,
                                   const Eigen::Vector3d& normal) {
  Segmentation image;
  image.width = width;
  image.height = height;
  image.labels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1);
  SegmentedPlane plane;
  plane.normal = normal;
  plane.d = 1.0;
  image.planes.push_back(plane);
  std::vector<PlaneSample> samples;
  std::vector<int> counts;
  samplePlanes(image, camera, samples, counts);
  EXPECT_EQ(samples.size(), static_cast<std::size_t>(counts.at(0)));
  return samples;
}

TEST(SamplePlanes, takesSome48PointsAcrossTheImage) {
  for (const int width : {160, 320, 640, 1280}) {
    const int height = width * 3 / 4;
    const std::size_t points =
        samplesOf(width, height, kinectCamera(width, height), -Eigen::Vector3d::UnitZ()).size();
    EXPECT_GE(points, 45U * 34U) << width;
    EXPECT_LE(points, 55U * 41U) << width;
  }
}

// Where a ray is nearly parallel to a plane, its point on the plane may be anywhere.
TEST(SamplePlanes, takesNoPointOfAPlaneSeenByItsEdge) {
  const auto points_at = [](double cosine) {
    return samplesOf(1, 1, {1.0, 1.0, 0.0, 0.0}, {std::sqrt(1.0 - cosine * cosine), 0.0, -cosine}).size();
  };
  EXPECT_EQ(0U, points_at(0.0007));
  EXPECT_EQ(1U, points_at(0.0015));
}

}  // namespace
}  // namespace line_plane_segmentation
