// SPDX-License-Identifier: BSD-3-Clause
#include "label_anchor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

Segmentation segmentationOf(int planes) {
  Segmentation segmentation;
  segmentation.width = kWidth;
  segmentation.height = kHeight;
  segmentation.labels.assign(std::size_t{kWidth} * kHeight, 0);
  segmentation.planes.resize(static_cast<std::size_t>(planes));
  return segmentation;
}

std::uint16_t& labelAt(Segmentation& segmentation, int u, int v) {
  return segmentation.labels[static_cast<std::size_t>(v * kWidth + u)];
}

void fill(Segmentation& segmentation, int first_u, int last_u, int first_v, int last_v, std::uint16_t label) {
  for (int v = first_v; v < last_v; ++v) {
    for (int u = first_u; u < last_u; ++u) labelAt(segmentation, u, v) = label;
  }
}

// Smallest distance from the anchor to a pixel of another label, along rows and columns.
int roomAround(Segmentation& segmentation, const LabelAnchor& anchor) {
  const std::uint16_t label = labelAt(segmentation, anchor.u, anchor.v);
  int room = kWidth;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      if (labelAt(segmentation, u, v) == label) continue;
      room = std::min(room, std::max(std::abs(u - anchor.u), std::abs(v - anchor.v)));
    }
  }
  return room;
}

TEST(LabelAnchor, IsTheMiddleOfARectangle) {
  Segmentation segmentation = segmentationOf(1);
  fill(segmentation, 100, 300, 200, 300, 1);
  const LabelAnchor anchor = labelAnchors(segmentation).at(0);
  ASSERT_TRUE(anchor.found);
  EXPECT_NEAR(200, anchor.u, 10);
  EXPECT_NEAR(250, anchor.v, 10);
}

// A wall behind a door frame, a floor around a table: the centroid of each lies on the other one.
TEST(LabelAnchor, LiesOnItsPlaneWhereTheMiddleDoesNot) {
  Segmentation segmentation = segmentationOf(2);
  fill(segmentation, 0, 640, 0, 480, 1);
  fill(segmentation, 120, 520, 90, 390, 2);
  fill(segmentation, 160, 480, 130, 350, 1);
  fill(segmentation, 280, 360, 200, 280, 0);
  const std::vector<LabelAnchor> anchors = labelAnchors(segmentation);
  for (const std::size_t k : {0U, 1U}) {
    ASSERT_TRUE(anchors.at(k).found);
    EXPECT_EQ(k + 1, labelAt(segmentation, anchors[k].u, anchors[k].v));
    EXPECT_GE(roomAround(segmentation, anchors[k]), k == 0 ? 30 : 10);
  }
}

TEST(LabelAnchor, SeesOverMissingPixels) {
  Segmentation segmentation = segmentationOf(1);
  fill(segmentation, 100, 300, 200, 300, 1);
  for (int i = 0; i < 200; ++i) labelAt(segmentation, 100 + i, 200 + 37 * i % 100) = 0;
  const LabelAnchor anchor = labelAnchors(segmentation).at(0);
  ASSERT_TRUE(anchor.found);
  EXPECT_NEAR(200, anchor.u, 10);
  EXPECT_NEAR(250, anchor.v, 10);
}

TEST(LabelAnchor, KeepsAwayFromTheBorderOfTheImage) {
  Segmentation segmentation = segmentationOf(1);
  fill(segmentation, 0, 20, 0, 480, 1);
  fill(segmentation, 0, 100, 0, 100, 1);
  const LabelAnchor anchor = labelAnchors(segmentation).at(0);
  ASSERT_TRUE(anchor.found);
  EXPECT_GE(anchor.u, 24);
  EXPECT_GE(anchor.v, 24);
}

TEST(LabelAnchor, OfNothingIsNotFound) {
  EXPECT_TRUE(labelAnchors(Segmentation{}).empty());
  EXPECT_FALSE(labelAnchors(segmentationOf(1)).at(0).found);
  Segmentation thin = segmentationOf(1);
  fill(thin, 0, 640, 240, 241, 1);
  EXPECT_FALSE(labelAnchors(thin).at(0).found);
  Segmentation row = segmentationOf(1);
  row.height = 1;
  row.labels.assign(kWidth, 1);
  EXPECT_FALSE(labelAnchors(row).at(0).found);
}

}  // namespace
}  // namespace line_plane_segmentation
