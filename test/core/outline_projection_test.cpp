// SPDX-License-Identifier: BSD-3-Clause
#include "outline/outline_projection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/outline_checks.h"
#include "core/outline_images.h"
#include "outline/outline.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

constexpr CameraIntrinsics kCamera{525.0, 520.0, 319.5, 239.5};

SegmentedPlane planeOf(const Eigen::Vector3d& normal, double d) {
  SegmentedPlane plane;
  plane.normal = normal.normalized();
  plane.d = d;
  return plane;
}

Eigen::Vector2d pixelOf(const Eigen::Vector3f& p) {
  return {kCamera.fx * p.x() / p.z() + kCamera.cx, kCamera.fy * p.y() / p.z() + kCamera.cy};
}

TEST(OutlineProjectionTest, VerticesLieOnThePixelsRays) {
  const std::vector<Eigen::Vector2d> ring = {{-0.5, -0.5}, {100.5, 479.5}, {639.5, 20.0}};
  const PlaneProjection projection(kCamera, planeOf({0.5, -0.3, -0.8}, 1.5), 640, 480);
  ASSERT_TRUE(projection.isVisible());
  std::vector<Eigen::Vector3f> vertices;
  ASSERT_TRUE(projection.project(ring, vertices));
  ASSERT_EQ(vertices.size(), ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_LT((pixelOf(vertices[i]) - ring[i]).norm(), 1e-3);
}

TEST(OutlineProjectionTest, APlaneSeenFromBehindOrByItsEdgeIsNotVisible) {
  EXPECT_FALSE(PlaneProjection(kCamera, planeOf({0.0, 0.0, 1.0}, 1.0), 640, 480).isVisible());
  EXPECT_FALSE(PlaneProjection(kCamera, planeOf({0.0, 0.0, -1.0}, 0.0), 640, 480).isVisible());
  EXPECT_FALSE(PlaneProjection(kCamera, planeOf({0.0, 0.0, -1.0}, -1.0), 640, 480).isVisible());
  EXPECT_TRUE(PlaneProjection(kCamera, planeOf({0.0, 0.0, -1.0}, 1.0), 640, 480).isVisible());
}

TEST(OutlineProjectionTest, AFloorGoesOnToItsHorizonAndNoFarther) {
  // A camera 0.3 m above a floor looks level: the upper half of the picture is above the horizon.
  const SegmentedPlane floor = planeOf({0.0, -1.0, 0.0}, 0.3);
  const PlaneProjection projection(kCamera, floor, 640, 480);
  std::vector<Eigen::Vector3f> vertices;
  ASSERT_TRUE(projection.project({{10.0, 200.0}, {10.0, 470.0}, {600.0, 470.0}, {600.0, 200.0}}, vertices));
  // One vertex more on each of the two edges that cross the line where the picture begins to be squeezed.
  ASSERT_EQ(vertices.size(), 6U);
  for (const Eigen::Vector3f& vertex : vertices) {
    EXPECT_NEAR(vertex.y(), 0.3F, 1e-6F);
    EXPECT_GT(vertex.z(), 0.6F);
    EXPECT_LE(vertex.z(), 30.001F);
  }
  EXPECT_LT((pixelOf(vertices[2]) - Eigen::Vector2d(10.0, 470.0)).norm(), 1e-3);
}

TEST(OutlineProjectionTest, WhateverThePlaneRingsAreFiniteOnItAndValid) {
  Random random(7);
  OutlineTracer tracer;
  OutlineParameters parameters;
  parameters.min_hole_pixels = 3;
  int outlined = 0, grazing = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Segmentation s =
        outlinePicture(seed % 2 == 0 ? OutlinePicture::kMosaic : OutlinePicture::kBlobs, 40, 30, seed);
    const CameraIntrinsics camera = outlineCamera(40, 30);
    for (SegmentedPlane& plane : s.planes) {
      plane.normal = random.direction();
      // Often just along some pixel's ray.
      const Eigen::Vector3d ray(random.uniform(-0.5, 0.5), random.uniform(-0.4, 0.4), 1.0);
      if (random.chance(0.5))
        plane.normal = (plane.normal - plane.normal.dot(ray) / ray.squaredNorm() * ray).normalized();
      plane.d = random.uniform(0.0, 1.0);
    }
    tracer.trace(camera, parameters, s);
    ASSERT_EQ(faultOf(s), "") << "seed " << seed;
    for (const SegmentedPlane& plane : s.planes) {
      const std::vector<Polygon> rings = ringsOnPlane(s, plane);
      ASSERT_EQ(faultOf(rings), "") << "seed " << seed << " normal " << plane.normal.transpose();
      for (std::size_t r = 0; r < rings.size(); ++r) {
        ASSERT_EQ(signedArea(rings[r]) > 0.0, static_cast<int>(r) < plane.outer_ring_count)
            << "seed " << seed;
      }
      outlined += rings.empty() ? 0 : 1;
      const bool is_far =
          std::any_of(s.vertices.begin(), s.vertices.end(), [](const auto& v) { return v.z() > 50.0F; });
      grazing += is_far ? 1 : 0;
    }
  }
  EXPECT_GT(outlined, 200);
  EXPECT_GT(grazing, 50);
}

TEST(OutlineProjectionTest, NoRingsWhereNumbersOverflow) {
  OutlineTracer tracer;
  Segmentation s = segmentationOf({"1111", "1111"});
  s.planes[0].d = 1e300;
  tracer.trace(outlineCamera(4, 2), OutlineParameters(), s);
  EXPECT_EQ(faultOf(s), "");
  EXPECT_TRUE(s.rings.empty());
  s.planes[0].d = 1.0;
  tracer.trace({1e-320, 1e-320, 2.0, 1.0}, OutlineParameters(), s);
  EXPECT_EQ(faultOf(s), "");
  EXPECT_TRUE(s.rings.empty());
}

TEST(OutlineProjectionTest, APlaneNearerThanAMicrometreIsNotVisible) {
  EXPECT_FALSE(PlaneProjection(kCamera, planeOf({0.0, 0.0, -1.0}, 0.7e-6), 640, 480).isVisible());
  EXPECT_TRUE(PlaneProjection(kCamera, planeOf({0.0, 0.0, -1.0}, 1.5e-6), 640, 480).isVisible());
}

TEST(OutlineProjectionTest, AVertexIsAtMost100TimesAsDeepAsThePlaneIsFar) {
  const PlaneProjection projection(kCamera, planeOf({0.0, -1.0, 0.0}, 0.3), 640, 480);
  std::vector<Eigen::Vector3f> vertices;
  ASSERT_TRUE(projection.project({{-0.5, -0.5}, {-0.5, 479.5}, {639.5, 479.5}, {639.5, -0.5}}, vertices));
  const auto is_nearer = [](const auto& a, const auto& b) { return a.z() < b.z(); };
  EXPECT_NEAR(std::max_element(vertices.begin(), vertices.end(), is_nearer)->z(), 30.0, 0.01);
}

}  // namespace
}  // namespace line_plane_segmentation
