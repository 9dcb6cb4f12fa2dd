// SPDX-License-Identifier: BSD-3-Clause
#include "room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer.h"
#include "simulated_camera.h"

namespace line_plane_segmentation::simulation {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kSeeds = 24;

TEST(SimulatedRoom, SeedsShowEveryFeature) {
  int counts[10] = {};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RoomFeatures f = simulatedRoom(seed).features;
    const bool has[10] = {f.ceiling,       f.vault, f.door,   f.step,   f.shelf,
                          f.leaning_board, f.ramp,  f.column, f.person, f.ball};
    for (int i = 0; i < 10; ++i) counts[i] += has[i] ? 1 : 0;
    EXPECT_FALSE(f.ceiling && f.vault);
  }
  for (const int count : counts) {
    EXPECT_GE(count, 2);
    EXPECT_LE(count, static_cast<int>(kSeeds) - 2);
  }
}

TEST(SimulatedRoom, IsTheSameForTheSameSeedOnly) {
  const Room room = simulatedRoom(7);
  const Room same = simulatedRoom(7);
  ASSERT_EQ(room.scene.faces().size(), same.scene.faces().size());
  for (std::size_t i = 0; i < room.scene.faces().size(); ++i) {
    EXPECT_EQ(room.scene.faces()[i].vertices, same.scene.faces()[i].vertices);
  }
  EXPECT_EQ(room.path.pose(3.3).matrix(), same.path.pose(3.3).matrix());
  EXPECT_NE(room.scene.faces()[0].vertices, simulatedRoom(8).scene.faces()[0].vertices);
  EXPECT_NE(room.path.pose(3.3).matrix(), simulatedRoom(8).path.pose(3.3).matrix());
}

// Every frame shows enough to work with, and the camera never sticks in something.
TEST(SimulatedRoom, AlwaysHasPlanesInView) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Room room = simulatedRoom(seed);
    for (double seconds = 0.0; seconds < 120.0; seconds += 5.0) {
      Rendering picture;
      render(room.scene, room.path.pose(seconds), kinectIntrinsics(80, 60), 80, 60, picture);
      int large = 0;
      for (const VisiblePlane& plane : picture.planes) large += plane.pixels > 80 * 60 / 50 ? 1 : 0;
      EXPECT_GE(large, 3) << "seed " << seed << " at " << seconds << " s";
      float nearest = 100.0F;
      for (const float depth : picture.depth) nearest = depth > 0.0F ? std::min(nearest, depth) : nearest;
      EXPECT_GT(nearest, 0.3F) << "seed " << seed << " at " << seconds << " s";
    }
  }
}

// With a roof every ray ends somewhere.
TEST(SimulatedRoom, WithARoofIsClosed) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Room room = simulatedRoom(seed);
    if (!room.features.ceiling && !room.features.vault) continue;
    for (int i = 0; i < 8; ++i) {
      Rendering picture;
      render(room.scene, lookingAlong({0.1, 0.9, 1.4}, 0.8 * i, 0.3 * i - 1.0, 0.0), {60, 60, 40, 30}, 80, 60,
             picture);
      for (const float depth : picture.depth) ASSERT_GT(depth, 0.0F) << "seed " << seed << " view " << i;
    }
  }
}

TEST(CameraPath, IsSlowAndSmoothAndStaysNearItsStation) {
  const Vector3d station(1.0, 2.0, 1.5);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CameraPath path(station, {1.0, 5.0, 0.7}, seed);
    constexpr double kStep = 1.0 / 30.0;
    double mean_speed = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Isometry3d here = path.pose(i * kStep);
      const Eigen::Isometry3d next = path.pose((i + 1) * kStep);
      const double speed = (next.translation() - here.translation()).norm() / kStep;
      const double turn = Eigen::AngleAxisd(here.linear().transpose() * next.linear()).angle() / kStep;
      ASSERT_LT(speed, 0.3);
      ASSERT_LT(turn, 30.0 / 57.3);
      ASSERT_LT((here.translation() - station).norm(), 0.6);
      ASSERT_NEAR(here.linear().determinant(), 1.0, 1e-12);
      mean_speed += speed / 3000.0;
    }
    EXPECT_GT(mean_speed, 0.05) << "it hardly moves";
  }
}

TEST(LookingAlong, HasXRightYDownZForward) {
  const Eigen::Isometry3d east = lookingAlong({1, 2, 3}, 0.0, 0.0, 0.0);
  EXPECT_TRUE((east.linear() * Vector3d::UnitZ()).isApprox(Vector3d::UnitX()));
  EXPECT_TRUE((east.linear() * Vector3d::UnitX()).isApprox(-Vector3d::UnitY()));
  EXPECT_TRUE((east.linear() * Vector3d::UnitY()).isApprox(-Vector3d::UnitZ()));
  EXPECT_TRUE(east.translation().isApprox(Vector3d(1, 2, 3)));

  const Eigen::Isometry3d up_north = lookingAlong({0, 0, 0}, 0.5 * 3.14159265358979, 0.3, 0.0);
  EXPECT_TRUE(
      (up_north.linear() * Vector3d::UnitZ()).isApprox(Vector3d(0, std::cos(0.3), std::sin(0.3)), 1e-9));

  // Clockwise as seen from behind: its right goes down.
  const Eigen::Isometry3d rolled = lookingAlong({0, 0, 0}, 0.0, 0.0, 0.2);
  EXPECT_NEAR((rolled.linear() * Vector3d::UnitX()).z(), -std::sin(0.2), 1e-12);
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
