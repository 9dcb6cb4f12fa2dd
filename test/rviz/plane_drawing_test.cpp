// SPDX-License-Identifier: BSD-3-Clause
// What the rviz display draws: filled polygons with holes, discs of uncertainty, colours.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "normal_uncertainty.h"
#include "plane_style.h"
#include "polygon_fill.h"

namespace line_plane_segmentation {
namespace {

const Eigen::Vector3d kNormal = Eigen::Vector3d(0.3, -0.5, -0.8).normalized();
const Eigen::Vector3d kCentre(1.0, -2.0, 3.0);

Eigen::Vector3d onPlane(double x, double y) {
  const Eigen::Vector3d u = kNormal.unitOrthogonal();
  return kCentre + x * u + y * kNormal.cross(u);
}

geometry_msgs::Polygon polygonOf(const std::vector<Eigen::Vector2d>& corners) {
  geometry_msgs::Polygon polygon;
  for (const Eigen::Vector2d& corner : corners) {
    const Eigen::Vector3f p = onPlane(corner.x(), corner.y()).cast<float>();
    geometry_msgs::Point32 point;
    point.x = p.x();
    point.y = p.y();
    point.z = p.z();
    polygon.points.push_back(point);
  }
  return polygon;
}

geometry_msgs::Polygon square(double x, double y, double side) {
  return polygonOf({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

Plane plane() {
  Plane plane;
  plane.coefficients.coef = {kNormal.x(), kNormal.y(), kNormal.z(), -kNormal.dot(kCentre)};
  plane.centroid.x = kCentre.x();
  plane.centroid.y = kCentre.y();
  plane.centroid.z = kCentre.z();
  return plane;
}

double areaOf(const std::vector<Triangle>& triangles) {
  double area = 0.0;
  for (const Triangle& t : triangles)
    area += 0.5 * static_cast<double>((t[1] - t[0]).cross(t[2] - t[0]).norm());
  return area;
}

TEST(PolygonFill, coversTheOutlineWithoutItsHoles) {
  Plane p = plane();
  p.outline = square(-1, -1, 2);
  EXPECT_NEAR(4.0, areaOf(fillOf(p)), 1e-3);
  p.holes = {square(-0.5, -0.5, 0.5), square(0.2, 0.2, 0.25)};
  EXPECT_NEAR(4.0 - 0.25 - 0.0625, areaOf(fillOf(p)), 1e-3);
  p.other_parts = {square(2, 2, 1)};
  p.holes.push_back(square(2.25, 2.25, 0.5));
  EXPECT_NEAR(4.0 - 0.25 - 0.0625 + 0.75, areaOf(fillOf(p)), 1e-3);
}

TEST(PolygonFill, liesOnThePlane) {
  Plane p = plane();
  p.outline = polygonOf({{-1, 0}, {0.3, -0.8}, {1.1, 0.2}, {0.1, 0.1}, {0, 1.2}});
  const std::vector<Triangle> triangles = fillOf(p);
  EXPECT_FALSE(triangles.empty());
  for (const Triangle& triangle : triangles) {
    for (const Eigen::Vector3f& corner : triangle) {
      EXPECT_NEAR(0.0, kNormal.dot(corner.cast<double>() - kCentre), 1e-5);
    }
  }
}

TEST(PolygonFill, fillsConcavePolygons) {
  Plane p = plane();
  p.outline = polygonOf({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  EXPECT_NEAR(7.0, areaOf(fillOf(p)), 1e-3);
}

TEST(PolygonFill, givesNothingForWhatIsNoPolygon) {
  Plane p = plane();
  EXPECT_TRUE(fillOf(p).empty());
  p.outline = polygonOf({{0, 0}, {1, 0}});
  EXPECT_TRUE(fillOf(p).empty());
  p.outline = square(0, 0, 1);
  p.outline.points[1].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(fillOf(p).empty());
  p.outline.points[1].y = 1e30F;
  EXPECT_TRUE(fillOf(p).empty());
}

TEST(NormalDisc, hasTheDeviationsAsRadii) {
  Plane p = plane();
  const Eigen::Vector3d u = kNormal.unitOrthogonal(), v = kNormal.cross(u);
  const Eigen::Matrix3d covariance = 0.01 * 0.01 * u * u.transpose() + 0.02 * 0.02 * v * v.transpose();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      p.covariance[static_cast<std::size_t>(4 * row + column)] = covariance(row, column);
    }
  }
  const std::vector<Triangle> disc = normalDisc(p, 0.5F, 10.0F);
  ASSERT_FALSE(disc.empty());
  EXPECT_NEAR(M_PI * (0.5 * 10 * 0.01) * (0.5 * 10 * 0.02), areaOf(disc), 2e-4) << "a polygon of 32 corners";
  for (const Triangle& triangle : disc) {
    EXPECT_NEAR(0.5, kNormal.dot(triangle[1].cast<double>() - kCentre), 1e-5) << "at the tip of the arrow";
  }
}

TEST(NormalDisc, isEmptyWithoutCovariance) { EXPECT_TRUE(normalDisc(plane(), 0.3F, 20.0F).empty()); }

TEST(PlaneStyle, coloursByIdOrientationOrArea) {
  Plane a = plane(), b = plane();
  a.id = 1;
  b.id = 2;
  a.orientation = b.orientation = Plane::VERTICAL;
  a.area = b.area = 1.0F;
  const auto is_same = [](const Color& x, const Color& y) { return x.r == y.r && x.g == y.g && x.b == y.b; };
  EXPECT_FALSE(is_same(colorOf(a, ColorBy::kId), colorOf(b, ColorBy::kId)));
  EXPECT_TRUE(is_same(colorOf(a, ColorBy::kId), colorOf(1U)));
  EXPECT_TRUE(is_same(colorOf(a, ColorBy::kOrientation), colorOf(b, ColorBy::kOrientation)));
  EXPECT_TRUE(is_same(colorOf(a, ColorBy::kArea), colorOf(b, ColorBy::kArea)));
  b.orientation = Plane::HORIZONTAL_UP;
  EXPECT_FALSE(is_same(colorOf(a, ColorBy::kOrientation), colorOf(b, ColorBy::kOrientation)));
  b.orientation = 200;
  colorOf(b, ColorBy::kOrientation);
  a.area = 0.0F;
  b.area = 100.0F;
  EXPECT_GT(colorOf(a, ColorBy::kArea).b, colorOf(a, ColorBy::kArea).r) << "small is blue";
  EXPECT_GT(colorOf(b, ColorBy::kArea).r, colorOf(b, ColorBy::kArea).b) << "large is red";
}

}  // namespace
}  // namespace line_plane_segmentation
