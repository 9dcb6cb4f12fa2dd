// SPDX-License-Identifier: BSD-3-Clause
#include "planes_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace line_plane_segmentation {
namespace {

using nlohmann::json;

void addRing(Segmentation& segmentation, const std::vector<Eigen::Vector3f>& vertices) {
  segmentation.rings.push_back(
      {static_cast<int>(segmentation.vertices.size()), static_cast<int>(vertices.size())});
  segmentation.vertices.insert(segmentation.vertices.end(), vertices.begin(), vertices.end());
}

// One plane with two parts and a hole after one without an outline.
Segmentation twoPlanes() {
  Segmentation segmentation;
  SegmentedPlane bare;
  bare.label = 1;
  bare.normal = {0.0, 0.0, -1.0};
  bare.d = 2.5;
  segmentation.planes.push_back(bare);

  SegmentedPlane plane;
  plane.label = 2;
  plane.normal = {0.6, 0.0, -0.8};
  plane.d = 0.125;
  plane.centroid = {1.0, -2.0, 3.0};
  plane.inliers = 4000;
  plane.rms = 0.005;
  plane.area = 0.75;
  plane.outer_ring_count = 2;
  plane.hole_count = 1;
  segmentation.planes.push_back(plane);
  addRing(segmentation, {{0.F, 0.F, 0.1F}, {1.F, 0.F, 0.2F}, {1.F, 1.F, 0.3F}, {0.F, 1.F, 0.4F}});
  addRing(segmentation, {{5.F, 0.F, 1.F}, {6.F, 0.F, 1.F}, {6.F, 1.F, 1.F}});
  addRing(segmentation, {{0.2F, 0.2F, 1.F}, {0.3F, 0.2F, 1.F}, {0.3F, 0.3F, 1.F}});
  return segmentation;
}

TEST(PlanesJson, HoldsEveryPlane) {
  const json document = json::parse(planesJson("frame 7", twoPlanes(), StageClock()));
  EXPECT_EQ(document["frame"], "frame 7");
  ASSERT_EQ(document["planes"].size(), 2U);
  const json& bare = document["planes"][0];
  EXPECT_EQ(bare["label"], 1);
  EXPECT_EQ(bare["d"], 2.5);
  EXPECT_EQ(bare["polygon"], json::array());
  EXPECT_EQ(bare["other_parts"], json::array());
  EXPECT_EQ(bare["holes"], json::array());

  const json& plane = document["planes"][1];
  EXPECT_EQ(plane["label"], 2);
  EXPECT_EQ(plane["normal"], json({0.6, 0.0, -0.8}));
  EXPECT_EQ(plane["centroid"], json({1.0, -2.0, 3.0}));
  EXPECT_EQ(plane["inliers"], 4000);
  EXPECT_EQ(plane["rms"], 0.005);
  EXPECT_EQ(plane["area"], 0.75);
  EXPECT_EQ(plane["polygon"], json::parse("[[0.0,0.0,0.1],[1.0,0.0,0.2],[1.0,1.0,0.3],[0.0,1.0,0.4]]"));
  EXPECT_EQ(plane["other_parts"], json::parse("[[[5.0,0.0,1.0],[6.0,0.0,1.0],[6.0,1.0,1.0]]]"));
  EXPECT_EQ(plane["holes"], json::parse("[[[0.2,0.2,1.0],[0.3,0.2,1.0],[0.3,0.3,1.0]]]"));
}

TEST(PlanesJson, HoldsTheTimeOfEachStage) {
  StageClock clock;
  clock.frameStarted();
  clock.stageFinished(Stage::kLines);
  clock.stageFinished(Stage::kExtraction);
  const json milliseconds = json::parse(planesJson("a", {}, clock))["milliseconds"];
  ASSERT_EQ(milliseconds.size(), static_cast<std::size_t>(kStageCount + 1));
  EXPECT_EQ(milliseconds["candidates"], 0.0);
  EXPECT_GE(milliseconds["lines"].get<double>(), 0.0);
  EXPECT_NEAR(milliseconds["total"].get<double>(),
              milliseconds["lines"].get<double>() + milliseconds["extraction"].get<double>(), 1e-9);
}

TEST(PlanesJson, IsTheSameTextForTheSamePlanes) {
  EXPECT_EQ(planesJson("a", twoPlanes(), StageClock()), planesJson("a", twoPlanes(), StageClock()));
}

TEST(PlanesJson, IsValidForAnyFileName) {
  EXPECT_NO_THROW(json::parse(planesJson("caf\xe9 \"x\"", {}, StageClock())));
}

}  // namespace
}  // namespace line_plane_segmentation
