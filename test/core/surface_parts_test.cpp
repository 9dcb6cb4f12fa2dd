// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/surface_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 160, kHeight = 120;

/// A track of a wall 2 m away that is not seen.
PlaneTrack trackOf(std::uint32_t id, std::uint32_t surface) {
  return {id, surface, 0.0, -Eigen::Vector3d::UnitZ(), 2.0, {0.0, 0.0, 2.0}, 0, 0, -1};
}

/// A track that was not matched, and samples of it in an image whose left half is one plane, 2 m away.
struct PartOfWall {
  int in_plane = 10, elsewhere = 0;  ///< samples in the left half and in the right half
  double distance = 0.0;             ///< [m] of the samples from the plane
  double angle = 0.0;                ///< [rad] between the normals

  /// Whether the track becomes a part of the plane's surface.
  bool isJoined() const {
    const CameraIntrinsics camera = kinectCamera(kWidth, kHeight);
    Segmentation image;
    image.width = kWidth;
    image.height = kHeight;
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) image.labels.push_back(u < kWidth / 2 ? 1 : 0);
    }
    SegmentedPlane plane;
    plane.normal = -Eigen::Vector3d::UnitZ();
    plane.d = 2.0;
    image.planes.push_back(plane);

    std::vector<PlaneSample> samples;
    for (int i = 0; i < in_plane + elsewhere; ++i) {
      const double u = i < in_plane ? 20.0 : 120.0, v = 10.0 + i, z = 2.0 + distance;
      samples.push_back(
          {Eigen::Vector3d(z * (u - camera.cx) / camera.fx, z * (v - camera.cy) / camera.fy, z).cast<float>(),
           1});
    }
    VoteTable votes;
    votes.count(samples, 2, image, camera);
    std::vector<PlaneTrack> tracks = {trackOf(1, 1), trackOf(2, 2)};
    tracks[0].plane = 0;
    tracks[1].normal = {std::sin(angle), 0.0, -std::cos(angle)};
    joinParts(image.planes, {0}, votes, tracks);
    return tracks[1].surface == 1;
  }
};

TEST(JoinParts, NeedsThreeInFiveOfThePointsInThePlane) {
  PartOfWall most, half;
  most.in_plane = 7;
  most.elsewhere = 3;
  half.in_plane = half.elsewhere = 5;
  EXPECT_TRUE(most.isJoined());
  EXPECT_FALSE(half.isJoined());
}

TEST(JoinParts, NeedsTwoPoints) {
  PartOfWall two, one;
  two.in_plane = 2;
  one.in_plane = 1;
  EXPECT_TRUE(two.isJoined());
  EXPECT_FALSE(one.isJoined());
}

TEST(JoinParts, NeedsTheDirectionOfThePlane) {
  PartOfWall alike, turned;
  alike.angle = 0.08;
  turned.angle = 0.13;
  EXPECT_TRUE(alike.isJoined());
  EXPECT_FALSE(turned.isJoined());
}

TEST(JoinParts, NeedsPointsWithinTwoPercentOfTheDepth) {
  PartOfWall near, far;
  near.distance = 0.03;
  far.distance = 0.055;
  EXPECT_TRUE(near.isJoined());
  EXPECT_FALSE(far.isJoined());
}

/// The id of the larger of two parts of a surface, whose id the smaller one has.
std::uint32_t idOfLarger(std::uint32_t larger, std::uint32_t smaller) {
  std::vector<PlaneTrack> tracks = {trackOf(1, 1), trackOf(2, 1)};
  tracks[0].pixels = smaller;
  tracks[1].pixels = larger;
  passIdsOn(0, tracks);
  return tracks[1].id;
}

TEST(PassIdsOn, GivesTheIdToAPartMoreThanTwiceAsLarge) {
  EXPECT_EQ(idOfLarger(250, 100), 1U);
  EXPECT_EQ(idOfLarger(150, 100), 2U);
}

}  // namespace
}  // namespace line_plane_segmentation
