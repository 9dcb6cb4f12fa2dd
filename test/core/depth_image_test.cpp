// SPDX-License-Identifier: BSD-3-Clause
#include "depth/depth_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

TEST(DepthImage, LoadsAWholeView) {
  const std::vector<std::uint16_t> pixels = {0, 1000, 2000, 3000, 20000, 500};
  DepthImage image;
  EXPECT_EQ(loadDepth(viewOf(pixels.data(), 3, 2), {0.3F, 10.0F}, image), 4U);
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  ASSERT_EQ(image.z.size(), 6U);
  const std::vector<float> expected = {0.0F, 1.0F, 2.0F, 3.0F, 0.0F, 0.5F};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_FLOAT_EQ(image.z[i], expected[i]) << i;
  EXPECT_FLOAT_EQ(image.at(2, 0), 2.0F);
  EXPECT_FLOAT_EQ(image.at(0, 1), 3.0F);
  EXPECT_EQ(image.row(1), &image.z[3]);
  EXPECT_EQ(image.index(2, 1), 5U);
}

TEST(DepthImage, ReusesItsMemory) {
  const std::vector<std::uint16_t> pixels(64, 1500);
  DepthImage image;
  loadDepth(viewOf(pixels.data(), 8, 8), {}, image);
  const float* memory = image.z.data();
  loadDepth(viewOf(pixels.data(), 4, 2), {}, image);
  EXPECT_EQ(image.z.size(), 8U);
  loadDepth(viewOf(pixels.data(), 8, 8), {}, image);
  EXPECT_EQ(image.z.data(), memory);
  EXPECT_EQ(std::count(image.z.begin(), image.z.end(), 1500 * 0.001F), 64);
}

TEST(DepthImage, OfAnEmptyViewIsEmpty) {
  DepthImage image = blankDepth(4, 4);
  EXPECT_EQ(loadDepth(DepthView{}, {}, image), 0U);
  EXPECT_EQ(image.width, 0);
  EXPECT_EQ(image.height, 0);
  EXPECT_TRUE(image.z.empty());
}

TEST(ViewRays, AreThoseOfThePinholeCamera) {
  const CameraIntrinsics camera{500.0, 400.0, 310.5, 230.25};
  const ViewRays rays = raysOf(camera, 640, 480);
  ASSERT_EQ(rays.x.size(), 640U);
  ASSERT_EQ(rays.y.size(), 480U);
  // Back to the pixel: u = fx X / Z + cx.
  for (int u = 0; u < 640; ++u)
    EXPECT_NEAR(camera.fx * rays.x[static_cast<std::size_t>(u)] + camera.cx, u, 1e-4);
  for (int v = 0; v < 480; ++v)
    EXPECT_NEAR(camera.fy * rays.y[static_cast<std::size_t>(v)] + camera.cy, v, 1e-4);
}

TEST(ViewRays, PutPointsOfAPlaneOntoThePlane) {
  const CameraIntrinsics camera = kinectCamera(64, 48);
  const ViewRays rays = raysOf(camera, 64, 48);
  const Surface surface = surfaceAt(2.0, 0.6, -0.4);
  const DepthImage depth = render(surface, camera, 64, 48);
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) {
      EXPECT_NEAR(surface.normal.dot(pointAt(depth, rays, u, v)) + surface.d, 0.0, 1e-6);
    }
  }
}

TEST(ViewRays, OfNoPixelsAreNone) {
  const ViewRays rays = raysOf(kinectCamera(640, 480), 0, 0);
  EXPECT_TRUE(rays.x.empty());
  EXPECT_TRUE(rays.y.empty());
}

TEST(CameraIntrinsics, AreValidOnlyIfFiniteWithPositiveFocalLengths) {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  EXPECT_TRUE((CameraIntrinsics{525, 525, 320, 240}.isValid()));
  EXPECT_TRUE((CameraIntrinsics{525, 525, -10, 1e4}.isValid()));
  EXPECT_FALSE(CameraIntrinsics{}.isValid());
  for (const double bad : {0.0, -525.0, nan, infinity, -infinity}) {
    EXPECT_FALSE((CameraIntrinsics{bad, 525, 320, 240}.isValid())) << bad;
    EXPECT_FALSE((CameraIntrinsics{525, bad, 320, 240}.isValid())) << bad;
  }
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE((CameraIntrinsics{525, 525, bad, 240}.isValid())) << bad;
    EXPECT_FALSE((CameraIntrinsics{525, 525, 320, bad}.isValid())) << bad;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
