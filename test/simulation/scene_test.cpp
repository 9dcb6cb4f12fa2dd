// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace line_plane_segmentation::simulation {
namespace {

using Eigen::Vector3d;

Eigen::Isometry3d turned() {
  return Eigen::Translation3d(0.3, -0.7, 0.2) * Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -0.5).normalized());
}

TEST(Scene, BoxLooksOutwardOnAllSides) {
  Scene scene;
  scene.addBox(turned(), {0.4, 0.6, 0.8});
  ASSERT_EQ(scene.faces().size(), 6U);
  EXPECT_EQ(scene.planes().size(), 6U);
  const Vector3d middle = turned() * Vector3d(0.0, 0.0, 0.4);
  double extent = 0.0;
  for (const Face& face : scene.faces()) {
    const double inside = scene.planes()[face.label - 1U].signedDistance(middle);
    EXPECT_LT(inside, -0.19);
    extent -= inside;
  }
  EXPECT_NEAR(extent, 0.4 + 0.6 + 0.8, 1e-12);
}

TEST(Scene, CoplanarFacesThatLookTheSameWayShareALabel) {
  Scene scene;
  const auto left = scene.addRectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  const auto right = scene.addRectangle({5, 3, 1}, {2, 1, 0}, {-1, 2, 0});
  const auto higher = scene.addRectangle({0, 0, 1.001}, {1, 0, 0}, {0, 1, 0});
  const auto from_below = scene.addRectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0});
  EXPECT_EQ(left, 1);
  EXPECT_EQ(right, 1);
  EXPECT_EQ(higher, 2);
  EXPECT_EQ(from_below, 3);
  EXPECT_EQ(scene.faces().size(), 4U);
  ASSERT_EQ(scene.planes().size(), 3U);
  EXPECT_TRUE(scene.planes()[0].normal().isApprox(Vector3d::UnitZ()));
  EXPECT_NEAR(scene.planes()[0].offset(), -1.0, 1e-12);
}

TEST(Scene, PlanesHoldTheirFacesVertices) {
  Scene scene;
  scene.addBox(turned(), {0.4, 0.6, 0.8});
  scene.addPolygon({{0, 0, 0}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}});
  for (const Face& face : scene.faces()) {
    for (const Vector3d& vertex : face.vertices) {
      EXPECT_NEAR(scene.planes()[face.label - 1U].signedDistance(vertex), 0.0, 1e-12);
    }
  }
}

TEST(Scene, RefusesWhatIsNoConvexPolygon) {
  Scene scene;
  const double s = 0.8, c = 0.3;
  EXPECT_THROW(scene.addPolygon({}), std::invalid_argument);
  EXPECT_THROW(scene.addPolygon({{0, 0, 0}, {1, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(scene.addPolygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), std::invalid_argument) << "a line";
  EXPECT_THROW(scene.addPolygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.01}, {0, 1, 0}}), std::invalid_argument)
      << "bent";
  EXPECT_THROW(scene.addPolygon({{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}}), std::invalid_argument)
      << "a dent";
  EXPECT_THROW(scene.addPolygon({{0, 1, 0}, {-c, -s, 0}, {s, c, 0}, {-s, c, 0}, {c, -s, 0}}),
               std::invalid_argument)
      << "a star";
  EXPECT_TRUE(scene.faces().empty());
  EXPECT_TRUE(scene.planes().empty());
}

TEST(CurvedBody, HasItsSurfaceWhereItsSizesSay) {
  const auto level = [](const CurvedBody& body, const Vector3d& p) {
    return (body.shape * (p - body.center)).norm();
  };
  const CurvedBody egg = ellipsoid({1, 2, 3}, {0.1, 0.2, 0.3});
  EXPECT_NEAR(level(egg, {1.1, 2, 3}), 1.0, 1e-12);
  EXPECT_NEAR(level(egg, {1, 2, 3.3}), 1.0, 1e-12);
  const CurvedBody pillar = column({1, 2, 0}, 0.5);
  EXPECT_NEAR(level(pillar, {1, 2.5, 7}), 1.0, 1e-12);
  const CurvedBody roof = vault({0, 0, 2}, 3, 1);
  EXPECT_NEAR(level(roof, {0, 9, 3}), 1.0, 1e-12);
  EXPECT_NEAR(level(roof, {-3, 9, 2}), 1.0, 1e-12);
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
