// SPDX-License-Identifier: BSD-3-Clause
#include "outline/outline.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "core/outline_checks.h"

namespace line_plane_segmentation {
namespace {

/// Without leaving out anything.
OutlineParameters fullDetail() {
  OutlineParameters parameters;
  parameters.outline_tolerance = 0.5;
  parameters.min_hole_pixels = 0;
  return parameters;
}

Segmentation traced(const std::vector<std::string>& rows,
                    const OutlineParameters& parameters = fullDetail()) {
  Segmentation segmentation = segmentationOf(rows);
  OutlineTracer().trace(outlineCamera(segmentation.width, segmentation.height), parameters, segmentation);
  return segmentation;
}

std::vector<Polygon> ringsOf(const Segmentation& segmentation, std::size_t plane = 0) {
  return ringsInImage(segmentation, segmentation.planes[plane],
                      outlineCamera(segmentation.width, segmentation.height));
}

/// Whether a ring is the one through these points [px], in this order, wherever it starts.
testing::AssertionResult isRing(const Polygon& ring, const Polygon& expected) {
  for (std::size_t shift = 0; shift < expected.size() && ring.size() == expected.size(); ++shift) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      farthest = std::max(farthest, (ring[i] - expected[(i + shift) % ring.size()]).norm());
    }
    if (farthest < 1e-4) return testing::AssertionSuccess();
  }
  testing::AssertionResult failure = testing::AssertionFailure();
  for (const Eigen::Vector2d& p : ring) failure << "(" << p.x() << ", " << p.y() << ") ";
  return failure;
}

TEST(OutlineTest, SquareRunsCounterclockwiseOverThePicture) {
  const Segmentation s = traced({".......",  //
                                 ".11111.",  //
                                 ".11111.",  //
                                 ".11111.",  //
                                 ".11111.",  //
                                 "......."});
  ASSERT_EQ(faultOf(s), "");
  EXPECT_EQ(s.planes[0].outer_ring_count, 1);
  EXPECT_EQ(s.planes[0].hole_count, 0);
  // Down along the left side, then to the right.
  EXPECT_TRUE(isRing(ringsOf(s)[0], {{0.5, 0.5}, {0.5, 4.5}, {5.5, 4.5}, {5.5, 0.5}}));
}

TEST(OutlineTest, HoleRunsClockwise) {
  const Segmentation s = traced({"1111111",  //
                                 "1111111",  //
                                 "11...11",  //
                                 "11...11",  //
                                 "1111111"});
  ASSERT_EQ(faultOf(s), "");
  EXPECT_EQ(s.planes[0].outer_ring_count, 1);
  ASSERT_EQ(s.planes[0].hole_count, 1);
  EXPECT_TRUE(isRing(ringsOf(s)[0], {{-0.5, -0.5}, {-0.5, 4.5}, {6.5, 4.5}, {6.5, -0.5}}));
  EXPECT_TRUE(isRing(ringsOf(s)[1], {{1.5, 1.5}, {4.5, 1.5}, {4.5, 3.5}, {1.5, 3.5}}));
}

TEST(OutlineTest, PartsCutByAnOccluderAreRingsTheLargestFirst) {
  const Segmentation s = traced({"111222.1111",  //
                                 "111222.1111",  //
                                 "111222.1111",  //
                                 "111222.1111"});
  ASSERT_EQ(faultOf(s), "");
  ASSERT_EQ(s.planes[0].outer_ring_count, 2);
  EXPECT_EQ(s.planes[0].hole_count, 0);
  EXPECT_TRUE(isRing(ringsOf(s)[0], {{6.5, -0.5}, {6.5, 3.5}, {10.5, 3.5}, {10.5, -0.5}}));
  EXPECT_TRUE(isRing(ringsOf(s)[1], {{-0.5, -0.5}, {-0.5, 3.5}, {2.5, 3.5}, {2.5, -0.5}}));
  ASSERT_EQ(s.planes[1].outer_ring_count, 1);
  EXPECT_TRUE(isRing(ringsOf(s, 1)[0], {{2.5, -0.5}, {2.5, 3.5}, {5.5, 3.5}, {5.5, -0.5}}));
}

TEST(OutlineTest, LShapeHasSixVertices) {
  const Segmentation s = traced({"111.....",  //
                                 "111.....",  //
                                 "111.....",  //
                                 "11111111",  //
                                 "11111111"});
  ASSERT_EQ(faultOf(s), "");
  EXPECT_TRUE(
      isRing(ringsOf(s)[0], {{-0.5, -0.5}, {-0.5, 4.5}, {7.5, 4.5}, {7.5, 2.5}, {2.5, 2.5}, {2.5, -0.5}}));
}

TEST(OutlineTest, IslandInAHoleIsAPart) {
  const Segmentation s = traced({"1111111",  //
                                 "1.....1",  //
                                 "1.111.1",  //
                                 "1.111.1",  //
                                 "1.....1",  //
                                 "1111111"});
  ASSERT_EQ(faultOf(s), "");
  ASSERT_EQ(s.planes[0].outer_ring_count, 2);
  ASSERT_EQ(s.planes[0].hole_count, 1);
  const std::vector<Polygon> rings = ringsOf(s);
  EXPECT_NEAR(signedArea(rings[0]), -42.0, 1e-3);
  EXPECT_NEAR(signedArea(rings[1]), -6.0, 1e-3);
  EXPECT_NEAR(signedArea(rings[2]), 20.0, 1e-3);
  EXPECT_TRUE(isInside(rings, {3.0, 2.0}));
  EXPECT_FALSE(isInside(rings, {3.0, 1.0}));
  EXPECT_TRUE(isInside(rings, {0.0, 3.0}));
}

TEST(OutlineTest, PixelsThatTouchAtACornerAreDrawnApart) {
  OutlineParameters exact = fullDetail();
  exact.outline_tolerance = 0.0;
  const Segmentation s = traced({"11..",  //
                                 "11..",  //
                                 "..11",  //
                                 "..11"},
                                exact);
  ASSERT_EQ(s.planes[0].outer_ring_count, 2);
  const std::vector<Polygon> rings = ringsOf(s);
  EXPECT_EQ(faultOf(rings), "");
  EXPECT_TRUE(isRing(rings[0], {{-0.5, -0.5}, {-0.5, 1.5}, {1.375, 1.375}, {1.5, -0.5}}));
  EXPECT_TRUE(isRing(rings[1], {{1.625, 1.625}, {1.5, 3.5}, {3.5, 3.5}, {3.5, 1.5}}));
}

TEST(OutlineTest, SmallHolesAreClosedAndSmallPartsLeftOut) {
  const std::vector<std::string> picture = {"1111111...",  //
                                            "1.11111..1",  //
                                            "1111111..1",  //
                                            "1111111.22",  //
                                            "1111111..2"};
  OutlineParameters parameters = fullDetail();
  EXPECT_EQ(traced(picture, parameters).planes[0].outer_ring_count, 2);
  EXPECT_EQ(traced(picture, parameters).planes[0].hole_count, 1);
  parameters.min_hole_pixels = 2;
  EXPECT_EQ(traced(picture, parameters).planes[0].outer_ring_count, 2);
  EXPECT_EQ(traced(picture, parameters).planes[0].hole_count, 0);
  parameters.min_hole_pixels = 4;
  const Segmentation s = traced(picture, parameters);
  ASSERT_EQ(faultOf(s), "");
  EXPECT_EQ(s.planes[0].outer_ring_count, 1);
  EXPECT_EQ(s.planes[0].hole_count, 0);
  // The largest part of a plane is there however small it is.
  EXPECT_EQ(s.planes[1].outer_ring_count, 1);
  EXPECT_EQ(s.planes[1].hole_count, 0);
}

TEST(OutlineTest, ALineOfPixelsHasARing) {
  for (const std::vector<std::string>& picture : {std::vector<std::string>{"1"},
                                                  {"111111111111"},
                                                  {"1", "1", "1", "1", "1"},
                                                  {".....", ".111.", "....."}}) {
    OutlineParameters parameters;
    for (const double tolerance : {0.5, 2.0, 20.0}) {
      parameters.outline_tolerance = tolerance;
      const Segmentation s = traced(picture, parameters);
      ASSERT_EQ(faultOf(s), "");
      ASSERT_EQ(s.planes[0].outer_ring_count, 1);
      EXPECT_EQ(faultOf(ringsOf(s)), "");
      EXPECT_LT(signedArea(ringsOf(s)[0]), -0.4);
    }
  }
}

TEST(OutlineTest, ToleranceSmoothesStairs) {
  std::vector<std::string> picture;
  for (int v = 0; v < 40; ++v)
    picture.push_back(std::string(static_cast<std::size_t>(10 + v / 2), '1') +
                      std::string(static_cast<std::size_t>(40 - v / 2), '.'));
  OutlineParameters parameters;
  parameters.outline_tolerance = 0.0;
  EXPECT_GT(traced(picture, parameters).vertices.size(), 40U);
  parameters.outline_tolerance = 2.0;
  EXPECT_EQ(traced(picture, parameters).vertices.size(), 4U);
}

/// A part whose lower border has a step of a pixel, and another part whose corner is at the step.
/// @return the number of the first part's vertices
int verticesWithStep(std::size_t before, std::size_t after) {
  std::vector<std::string> picture(3, std::string(before + after, '1'));
  picture.push_back(std::string(before, '.') + std::string(after, '1'));
  picture.insert(picture.end(), 4, std::string(before, '1') + std::string(after, '.'));
  OutlineParameters parameters = fullDetail();
  parameters.outline_tolerance = 1.0;
  return traced(picture, parameters).rings.at(0).vertex_count;
}

// An edge in place of the step would pass the corner by 3 / 7 or by 2 / 9 of a pixel in x and in y.
TEST(OutlineTest, EdgesKeepAwayFromCornersByThreeTenthsOfAPixel) {
  EXPECT_EQ(verticesWithStep(3, 3), 4);
  EXPECT_EQ(verticesWithStep(6, 2), 5);
}

TEST(OutlineTest, WhatSticksOutBeyondTheEndOfAnEdgeIsKept) {
  // The tip on the left is near the line through the two ends of the figure, but far from both.
  std::vector<std::string> picture(8, std::string(28, '.') + std::string(23, '1'));
  picture[0] = std::string(10, '.') + std::string(41, '1');
  picture[1] = std::string(51, '1');
  OutlineParameters parameters;
  parameters.outline_tolerance = 5.0;
  const Segmentation s = traced(picture, parameters);
  EXPECT_LE(distanceToRing(ringsOf(s)[0], {-0.5, 1.5}), 5.0);
}

TEST(OutlineTest, CounterclockwiseAboutTheNormal) {
  for (const Eigen::Vector3d& normal :
       {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0.6, 0.1, -0.7), Eigen::Vector3d(-0.3, -0.9, -0.4)}) {
    Segmentation s = segmentationOf({"1111111", "11...11", "11...11", "11...11", "1111111"});
    tilt(normal, 2.0, s.planes[0]);
    OutlineTracer().trace(outlineCamera(s.width, s.height), fullDetail(), s);
    ASSERT_EQ(faultOf(s), "");
    ASSERT_EQ(s.rings.size(), 2U);
    EXPECT_GT(signedArea(ringsOnPlane(s, s.planes[0])[0]), 0.0);
    EXPECT_LT(signedArea(ringsOnPlane(s, s.planes[0])[1]), 0.0);
  }
}

TEST(OutlineTest, LabelsWithoutPlanesAreNoPlane) {
  Segmentation s = segmentationOf({"1133", "1133", "2233"});
  s.planes.resize(2);
  OutlineTracer().trace(outlineCamera(4, 3), fullDetail(), s);
  EXPECT_EQ(faultOf(s), "");
  EXPECT_EQ(s.rings.size(), 2U);
}

TEST(OutlineTest, NothingIsTracedOnRequest) {
  Segmentation s = traced({"111", "111"});
  ASSERT_EQ(s.rings.size(), 1U);
  OutlineParameters off;
  off.trace_outlines = false;
  OutlineTracer().trace(outlineCamera(3, 2), off, s);
  EXPECT_TRUE(s.rings.empty());
  EXPECT_TRUE(s.vertices.empty());
  EXPECT_EQ(s.planes[0].outer_ring_count, 0);
  EXPECT_EQ(s.planes[0].hole_count, 0);
}

TEST(OutlineTest, InputWithoutSenseHasNoRings) {
  OutlineTracer tracer;
  Segmentation empty;
  tracer.trace(outlineCamera(4, 4), fullDetail(), empty);
  EXPECT_EQ(faultOf(empty), "");

  Segmentation too_short = segmentationOf({"11", "11"});
  too_short.height = 3;
  tracer.trace(outlineCamera(2, 2), fullDetail(), too_short);
  EXPECT_TRUE(too_short.rings.empty());

  Segmentation square = segmentationOf({"11", "11"});
  tracer.trace(CameraIntrinsics{}, fullDetail(), square);
  EXPECT_TRUE(square.rings.empty());
  for (const double d :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    square.planes[0].d = d;
    tracer.trace(outlineCamera(2, 2), fullDetail(), square);
    EXPECT_EQ(faultOf(square), "");
    EXPECT_TRUE(square.rings.empty());
  }
  tilt({0.0, 0.0, std::numeric_limits<double>::quiet_NaN()}, 1.0, square.planes[0]);
  tracer.trace(outlineCamera(2, 2), fullDetail(), square);
  EXPECT_TRUE(square.rings.empty());
}

TEST(OutlineTest, NothingChangesWhatTheNextImageGives) {
  OutlineTracer tracer;
  Segmentation first = segmentationOf({"1111..", "1.11.2", "1111.2", "....2."});
  Segmentation second = segmentationOf({"12", "21", "12"});
  Segmentation again = first;
  tracer.trace(outlineCamera(6, 4), fullDetail(), first);
  tracer.trace(outlineCamera(2, 3), fullDetail(), second);
  tracer.trace(outlineCamera(6, 4), fullDetail(), again);
  ASSERT_EQ(first.vertices.size(), again.vertices.size());
  for (std::size_t i = 0; i < first.vertices.size(); ++i) EXPECT_EQ(first.vertices[i], again.vertices[i]);
  EXPECT_EQ(first.rings.size(), again.rings.size());
}

}  // namespace
}  // namespace line_plane_segmentation
