// SPDX-License-Identifier: BSD-3-Clause
#include "lines/scanline.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>

#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr ScanDirection kDirections[] = {ScanDirection::kRow, ScanDirection::kColumn};
const CameraIntrinsics kUnequalAxes{60.0, 50.0, 30.3, 22.8};

int pixelU(const Scanline& scan, const ScanPoint& point) {
  return scan.direction == ScanDirection::kRow ? point.pixel : scan.index;
}
int pixelV(const Scanline& scan, const ScanPoint& point) {
  return scan.direction == ScanDirection::kRow ? scan.index : point.pixel;
}

TEST(ScanlineCount, IsThePapersForQvgaAndVga) {
  EXPECT_EQ(scanlineCount(240, 20), 11);
  EXPECT_EQ(scanlineCount(320, 20), 15);
  EXPECT_EQ(scanlineCount(640, 30), 21);
  // The paper has 14 rows here, though a fifteenth, row 450, lies in the image.
  EXPECT_EQ(scanlineCount(480, 30), 15);
}

TEST(ScanlineCount, CountsEverySpacingthPixelButTheFirst) {
  for (int pixels = 0; pixels < 70; ++pixels) {
    for (int spacing = 1; spacing < 40; ++spacing) {
      int expected = 0;
      for (int pixel = spacing; pixel < pixels; pixel += spacing) ++expected;
      EXPECT_EQ(scanlineCount(pixels, spacing), expected) << pixels << ' ' << spacing;
    }
  }
}

TEST(ProjectScanline, HoldsEquations1To3) {
  const DepthImage depth = randomScene(3, 64, 48);
  Scanline scan;
  for (const ScanDirection direction : kDirections) {
    for (int index = 0; index < (direction == ScanDirection::kRow ? 48 : 64); ++index) {
      projectScanline(depth, kUnequalAxes, direction, index, scan);
      EXPECT_EQ(scan.direction, direction);
      EXPECT_EQ(scan.index, index);
      for (const ScanPoint& point : scan.points) {
        const int u = pixelU(scan, point), v = pixelV(scan, point);
        const double pz = depth.at(u, v);
        const double px = (u - kUnequalAxes.cx) / kUnequalAxes.fx * pz;
        const double py = (v - kUnequalAxes.cy) / kUnequalAxes.fy * pz;
        const double along = direction == ScanDirection::kRow ? px : py;
        const double across = direction == ScanDirection::kRow ? py : px;
        EXPECT_NEAR(point.x, std::hypot(across, pz), 1e-12);
        EXPECT_NEAR(point.y, along, 1e-12);
        EXPECT_EQ(point.z, pz);
      }
    }
  }
}

TEST(ProjectScanline, LeavesOutHolesAndKeepsTheirPlace) {
  DepthImage depth = blankDepth(8, 3);
  for (const int u : {1, 2, 5, 7}) depth.row(1)[u] = 1.0F + 0.1F * static_cast<float>(u);
  Scanline scan;
  projectScanline(depth, kinectCamera(8, 3), ScanDirection::kRow, 1, scan);
  ASSERT_EQ(scan.points.size(), 4U);
  EXPECT_EQ(scan.points[0].pixel, 1);
  EXPECT_EQ(scan.points[1].pixel, 2);
  EXPECT_EQ(scan.points[2].pixel, 5);
  EXPECT_EQ(scan.points[3].pixel, 7);
  projectScanline(depth, kinectCamera(8, 3), ScanDirection::kColumn, 5, scan);
  ASSERT_EQ(scan.points.size(), 1U);
  EXPECT_EQ(scan.points[0].pixel, 1);
  EXPECT_EQ(scan.points[0].z, depth.at(5, 1));
}

TEST(ProjectScanline, OfNoDepthIsEmpty) {
  Scanline scan;
  scan.points.resize(3);
  projectScanline(blankDepth(8, 3), kinectCamera(8, 3), ScanDirection::kRow, 0, scan);
  EXPECT_TRUE(scan.points.empty());
}

TEST(ProjectScanline, OfAPlaneIsALine) {
  const Surface surfaces[] = {surfaceAt(1.0), surfaceAt(2.0, 0.7, 0.0), surfaceAt(3.0, -0.4, 0.9)};
  Scanline scan;
  for (const Surface& surface : surfaces) {
    const DepthImage depth = render(surface, kUnequalAxes, 64, 48);
    for (const ScanDirection direction : kDirections) {
      projectScanline(depth, kUnequalAxes, direction, 20, scan);
      ASSERT_GE(scan.points.size(), 48U);
      Eigen::MatrixX2d points(static_cast<Eigen::Index>(scan.points.size()), 2);
      for (std::size_t i = 0; i < scan.points.size(); ++i) {
        points.row(static_cast<Eigen::Index>(i)) << scan.points[i].x, scan.points[i].y;
      }
      points.rowwise() -= points.colwise().mean().eval();
      const Eigen::JacobiSVD<Eigen::MatrixX2d> svd(points);
      const double rms = svd.singularValues()[1] / std::sqrt(static_cast<double>(scan.points.size()));
      EXPECT_LT(rms, 1e-6);
      EXPECT_GT(svd.singularValues()[0], 0.1);
    }
  }
}

}  // namespace
}  // namespace line_plane_segmentation
