// SPDX-License-Identifier: BSD-3-Clause
// The parts of KinectNoise that take pixels away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "noise_pictures.h"

namespace line_plane_segmentation::simulation {
namespace {

// A post 1 m away before a wall 3 m away. Where the wall is seen left of the post, its light would have
// to pass through the post: f b (1/1 - 1/3) pixels.
TEST(MissingPixels, ProjectorsShadowLiesLeftOfWhatCastsIt) {
  Scene scene;
  scene.addRectangle({-100, -100, 3}, {0, 200, 0}, {200, 0, 0});
  const auto post = scene.addRectangle({-0.05, -100, 1}, {0, 200, 0}, {0.1, 0, 0});
  const Rendering picture = pictureOf(scene);
  KinectNoiseParameters p = allOff();
  p.projector_shadow = true;
  const Image mm = apply(p, picture);
  for (const int v : {0, 200, kHeight - 1}) {
    const auto row = static_cast<std::size_t>(v) * kWidth;
    std::size_t left = row;
    while (picture.labels[left] != post) ++left;
    const auto missing =
        std::count(mm.begin() + static_cast<long>(row), mm.begin() + static_cast<long>(row) + kWidth, 0);
    EXPECT_NEAR(static_cast<double>(missing), 525.0 * 0.075 * (1.0 - 1.0 / 3.0), 1.0);
    for (std::size_t i = left - static_cast<std::size_t>(missing); i < left; ++i) EXPECT_EQ(mm[i], 0);
  }
}

TEST(MissingPixels, PixelsGoMissingAtDepthEdgesOnly) {
  Scene scene;
  scene.addRectangle({-100, -100, 3}, {0, 200, 0}, {200, 0, 0});
  const auto board = scene.addRectangle({-1, -0.7, 2}, {0, 1.4, 0}, {2, 0, 0});
  const Rendering picture = pictureOf(scene);
  KinectNoiseParameters p = allOff();
  p.edge_dropout = 0.4;
  const Image mm = apply(p, picture);
  int at_edge = 0;
  int missing = 0;
  for (int v = 1; v + 1 < kHeight; ++v) {
    for (int u = 1; u + 1 < kWidth; ++u) {
      const auto i = static_cast<std::size_t>(v * kWidth + u);
      const bool on_board = picture.labels[i] == board;
      bool edge = false;
      for (const std::size_t other : {i - 1, i + 1, i - kWidth, i + kWidth}) {
        edge |= (picture.labels[other] == board) != on_board;
      }
      at_edge += edge ? 1 : 0;
      missing += edge && mm[i] == 0 ? 1 : 0;
      if (!edge) {
        ASSERT_NE(mm[i], 0) << u << ", " << v;
      }
    }
  }
  ASSERT_GT(at_edge, 2000);
  EXPECT_NEAR(static_cast<double>(missing) / at_edge, 0.4, 0.04);
}

TEST(MissingPixels, GrazedSurfacesGoMissing) {
  KinectNoiseParameters p = allOff();
  p.grazing_start = 1.36;
  p.grazing_end = 1.50;
  // A floor 1 m under the camera, whose row v is seen at the angle atan(fy / (v - cy)) to its normal.
  Scene scene;
  scene.addRectangle({-1000, 1, -1000}, {2000, 0, 0}, {0, 0, 2000});
  const CameraIntrinsics narrow{2000.0, 2000.0, 0.5 * (kWidth - 1), 100.0};
  Rendering picture;
  render(scene, Eigen::Isometry3d::Identity(), narrow, kWidth, kHeight, picture);
  Image mm(picture.depth.size());
  KinectNoise(p).apply(picture, narrow, 0, mm.data());
  const auto share_in_row = [&](int v) {
    const auto row = mm.begin() + static_cast<long>(v) * kWidth;
    return static_cast<double>(std::count(row, row + kWidth, 0)) / kWidth;
  };
  EXPECT_EQ(share_in_row(101 + 130), 1.0) << "86.3 degrees";
  EXPECT_NEAR(share_in_row(101 + 280), 0.49, 0.1) << "82 degrees";
  EXPECT_NEAR(share_in_row(kHeight - 1), 0.16, 0.08) << "79.3 degrees";
  EXPECT_EQ(missingShare(apply(p, wallAt(2.0))), 0.0);
}

// It is the ray that counts, not the optical axis: a wide lens grazes at its border a wall that faces it.
TEST(MissingPixels, GrazingIsJudgedAlongEachPixelsRay) {
  Scene scene;
  scene.addRectangle({-1000, -1000, 1}, {0, 2000, 0}, {2000, 0, 0});
  const CameraIntrinsics wide{40.0, 40.0, 0.5 * (kWidth - 1), 0.0};
  Rendering picture;
  render(scene, Eigen::Isometry3d::Identity(), wide, kWidth, kHeight, picture);
  KinectNoiseParameters p = allOff();
  p.grazing_start = 1.20;
  p.grazing_end = 1.30;
  Image mm(picture.depth.size());
  KinectNoise(p).apply(picture, wide, 0, mm.data());
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double angle = std::atan(std::hypot((u - wide.cx) / wide.fx, v / wide.fy));
      const bool missing = mm[static_cast<std::size_t>(v * kWidth + u)] == 0;
      ASSERT_FALSE(missing && angle < 1.1999) << u << ", " << v;
      ASSERT_FALSE(!missing && angle > 1.3001) << u << ", " << v;
    }
  }
}

TEST(MissingPixels, KeepsToItsRange) {
  EXPECT_EQ(missingShare(apply({}, wallAt(0.3))), 1.0);
  EXPECT_EQ(missingShare(apply({}, wallAt(13.0))), 1.0);
  EXPECT_EQ(missingShare(apply({}, wallAt(1.0))), 0.0);
  for (const std::uint16_t pixel : apply({}, wallAt(10.0))) {
    ASSERT_LE(pixel, 10000);
  }
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
