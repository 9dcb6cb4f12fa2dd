// SPDX-License-Identifier: BSD-3-Clause
#include "renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "brute_force_ray.h"
#include "room.h"
#include "simulated_camera.h"

namespace line_plane_segmentation::simulation {
namespace {

using Eigen::Vector3d;

const Eigen::Isometry3d kOrigin = Eigen::Isometry3d::Identity();

Rendering renderedBy(const Scene& scene, const Eigen::Isometry3d& camera, int width, int height) {
  Rendering picture;
  render(scene, camera, kinectIntrinsics(width, height), width, height, picture);
  return picture;
}

/// A wall that faces a camera at the origin and fills its view.
Scene wallAt(double z) {
  Scene scene;
  scene.addRectangle({-100, -100, z}, {0, 200, 0}, {200, 0, 0});
  return scene;
}

void expectAsBruteForce(const Scene& scene, const Eigen::Isometry3d& camera, const CameraIntrinsics& k,
                        int width, int height) {
  Rendering picture;
  render(scene, camera, k, width, height, picture);
  int wrong = 0;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const auto i = static_cast<std::size_t>(v * width + u);
      const Hit hit = BruteForceRay(camera, k, u, v).cast(scene);
      const double expected = hit.missed() ? 0.0 : hit.depth;
      const bool right =
          picture.labels[i] == hit.label && std::abs(picture.depth[i] - expected) <= 1e-6 * expected;
      if (!right && ++wrong <= 5) {
        ADD_FAILURE() << "pixel " << u << ", " << v << ": label " << picture.labels[i] << " at "
                      << picture.depth[i] << " m, not " << hit.label << " at " << expected << " m";
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Renderer, SeesRoomsAsBruteForceDoes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Room room = simulatedRoom(seed);
    for (const double seconds : {0.0, 31.0}) {
      SCOPED_TRACE("room " + std::to_string(seed) + " at " + std::to_string(seconds) + " s");
      expectAsBruteForce(room.scene, room.path.pose(seconds), kinectIntrinsics(96, 72), 96, 72);
    }
  }
}

TEST(Renderer, SeesAsBruteForceFromAnywhere) {
  RoomFeatures all;
  all.vault = all.door = all.step = all.shelf = all.leaning_board = all.ramp = all.column = all.person =
      all.ball = true;
  const Room room = simulatedRoom(8, all);
  const CameraIntrinsics wide_and_skew{15.0, 20.5, 11.5, 30.25};
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Vector3d position(0.1 * i - 0.6, 0.4 + 0.3 * i, 0.3 + 0.13 * i);
    expectAsBruteForce(room.scene, lookingAlong(position, 0.55 * i, 0.25 * i - 1.5, 0.5 * i), wide_and_skew,
                       45, 35);
  }
}

TEST(Renderer, DepthLabelsAndPlanesAgreeExactly) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Room room = simulatedRoom(seed);
    const CameraIntrinsics k = kinectIntrinsics(320, 240);
    const Rendering picture = renderedBy(room.scene, room.path.pose(3.0), 320, 240);
    std::map<std::uint16_t, VisiblePlane> planes;
    for (const VisiblePlane& plane : picture.planes) {
      EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-12);
      EXPECT_GT(plane.d, 0.0);
      planes[plane.label] = plane;
    }
    EXPECT_EQ(planes.size(), picture.planes.size());
    std::map<std::uint16_t, std::uint32_t> pixels;
    for (std::size_t i = 0; i < picture.labels.size(); ++i) {
      const std::uint16_t label = picture.labels[i];
      if (label == 0) continue;
      ++pixels[label];
      ASSERT_EQ(planes.count(label), 1U) << "a label whose plane is not told";
      const double z = static_cast<double>(picture.depth[i]);
      const Vector3d point((static_cast<double>(i % 320) - k.cx) / k.fx * z,
                           (static_cast<double>(i / 320) - k.cy) / k.fy * z, z);
      ASSERT_NEAR(planes[label].normal.dot(point) + planes[label].d, 0.0, 1e-6) << "pixel " << i;
    }
    for (const VisiblePlane& plane : picture.planes) EXPECT_EQ(plane.pixels, pixels[plane.label]);
    EXPECT_EQ(pixels.size(), planes.size()) << "a plane that no pixel shows";
  }
}

TEST(Renderer, GivesTheSamePictureBitByBit) {
  const Room room = simulatedRoom(3);
  const Rendering once = renderedBy(room.scene, room.path.pose(2.0), 320, 240);
  Rendering again = renderedBy(simulatedRoom(4).scene, room.path.pose(9.0), 640, 480);
  render(room.scene, room.path.pose(2.0), kinectIntrinsics(320, 240), 320, 240, again);
  EXPECT_EQ(once.depth, again.depth);
  EXPECT_EQ(once.labels, again.labels);
  EXPECT_EQ(once.planes.size(), again.planes.size());
}

TEST(Renderer, OnePlaneHasOneLabelOnBothSidesOfWhatHidesIt) {
  Scene scene = wallAt(2.0);
  const auto post = scene.addRectangle({-0.1, -100, 1.0}, {0, 200, 0}, {0.2, 0, 0});
  const Rendering picture = renderedBy(scene, kOrigin, 64, 48);
  ASSERT_EQ(picture.planes.size(), 2U);
  EXPECT_EQ(picture.labels[24 * 64 + 3], 1);
  EXPECT_EQ(picture.labels[24 * 64 + 32], post);
  EXPECT_EQ(picture.labels[24 * 64 + 60], 1);
  EXPECT_EQ(picture.planes[0].pixels + picture.planes[1].pixels, 64U * 48U);
}

TEST(Renderer, EmptySceneHasNoDepth) {
  const Rendering picture = renderedBy(Scene(), kOrigin, 33, 17);
  EXPECT_EQ(picture.depth, std::vector<float>(33 * 17, 0.0F));
  EXPECT_EQ(picture.labels, std::vector<std::uint16_t>(33 * 17, 0));
  EXPECT_TRUE(picture.planes.empty());
}

TEST(Renderer, ManagesTheSmallestImages) {
  const Rendering point = renderedBy(wallAt(1.5), kOrigin, 1, 1);
  ASSERT_EQ(point.depth.size(), 1U);
  EXPECT_FLOAT_EQ(point.depth[0], 1.5F);
  EXPECT_EQ(point.labels[0], 1);
  ASSERT_EQ(point.planes.size(), 1U);
  EXPECT_TRUE(point.planes[0].normal.isApprox(-Vector3d::UnitZ()));
  EXPECT_NEAR(point.planes[0].d, 1.5, 1e-12);
  Rendering nothing = point;
  render(wallAt(1.5), kOrigin, {1, 1, 0, 0}, 0, 5, nothing);
  EXPECT_TRUE(nothing.depth.empty() && nothing.labels.empty() && nothing.planes.empty());
  render(wallAt(1.5), kOrigin, {1, 1, 0, 0}, 5, 0, nothing);
  EXPECT_TRUE(nothing.depth.empty() && nothing.labels.empty() && nothing.planes.empty());
  EXPECT_EQ(renderedBy(wallAt(1.5), kOrigin, 7, 1).depth, std::vector<float>(7, 1.5F));
}

TEST(Renderer, SeesNothingFromBehindAndNothingBehindTheCamera) {
  EXPECT_TRUE(renderedBy(wallAt(-1.0), kOrigin, 32, 24).planes.empty());
  Scene turned_away;
  turned_away.addRectangle({-100, -100, 2}, {200, 0, 0}, {0, 200, 0});
  EXPECT_TRUE(renderedBy(turned_away, kOrigin, 32, 24).planes.empty());
  Scene around_the_camera;
  around_the_camera.addCurvedBody(ellipsoid({0, 0, 0}, {1, 1, 1}));
  around_the_camera.addCurvedBody(ellipsoid({0, 0, -3}, {1, 1, 1}));
  EXPECT_EQ(renderedBy(around_the_camera, kOrigin, 32, 24).depth, std::vector<float>(32 * 24, 0.0F));
}

// Pixel centres that lie exactly on a common side belong to one of the two faces.
TEST(Renderer, NoRayPassesBetweenFaces) {
  Scene scene;
  scene.addRectangle({-1, -1, 1}, {0, 2, 0}, {1, 0, 0});
  scene.addRectangle({0, -1, 1}, {0, 2, 0}, {1, 0, 0});
  Rendering picture;
  render(scene, kOrigin, {20.0, 20.0, 10.0, 10.0}, 21, 21, picture);
  EXPECT_EQ(std::count(picture.labels.begin(), picture.labels.end(), 1), 21 * 21);

  for (int i = 0; i < 50; ++i) {
    Scene box;  // seen from all sides against the sky: a gap would show as a hole in a row
    box.addBox(
        Eigen::Translation3d(0, 0, 1) * Eigen::AngleAxisd(0.37 * i, Vector3d(1, 0.1 * i, 0.3).normalized()),
        {0.4, 0.3, 0.2});
    const Rendering seen = renderedBy(box, kOrigin, 80, 60);
    for (int v = 0; v < 60; ++v) {
      int borders = 0;
      for (int u = 1; u < 80; ++u) {
        const auto here = static_cast<std::size_t>(80 * v + u);
        borders += (seen.labels[here] == 0) != (seen.labels[here - 1] == 0) ? 1 : 0;
      }
      ASSERT_LE(borders, 2) << "box " << i << " row " << v;
    }
  }
}

TEST(Renderer, RefusesAnImpossibleCamera) {
  Rendering picture;
  EXPECT_THROW(render(wallAt(1), kOrigin, {}, 4, 4, picture), std::invalid_argument);
  EXPECT_THROW(
      render(wallAt(1), kOrigin, {1.0, std::numeric_limits<double>::quiet_NaN(), 0, 0}, 4, 4, picture),
      std::invalid_argument);
  EXPECT_THROW(render(wallAt(1), kOrigin, {1, 1, 0, 0}, -1, 4, picture), std::invalid_argument);
}

TEST(ToMillimetres, RoundsAndMarksWhatIsMissing) {
  Rendering picture;
  picture.width = 6;
  picture.height = 1;
  picture.depth = {0.0F, 1.2344F, 1.2346F, 0.0004F, 65.535F, 65.6F};
  std::vector<std::uint16_t> mm(6, 9999);
  toMillimetres(picture, mm.data());
  EXPECT_EQ(mm, (std::vector<std::uint16_t>{0, 1234, 1235, 0, 65535, 0}));
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
