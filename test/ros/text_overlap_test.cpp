// SPDX-License-Identifier: BSD-3-Clause
#include "text_overlap.h"

#include <gtest/gtest.h>

namespace line_plane_segmentation {
namespace {

const CameraIntrinsics kCamera{500.0, 500.0, 320.0, 240.0};

TEST(TextOverlapFilter, keepsTextsApart) {
  TextOverlapFilter overlap_filter(kCamera);
  EXPECT_TRUE(overlap_filter.addIfFree({0.0, 0.0, 2.0}, 0.1, "1: 2.00 m^2\nvertical"));
  EXPECT_FALSE(overlap_filter.addIfFree({0.1, 0.0, 2.0}, 0.1, "2: 2.00 m^2")) << "beside it";
  EXPECT_FALSE(overlap_filter.addIfFree({0.0, 0.1, 2.0}, 0.1, "2")) << "below it";
  EXPECT_FALSE(overlap_filter.addIfFree({0.0, 0.0, 1.0}, 0.05, "2")) << "in front of it";
  EXPECT_TRUE(overlap_filter.addIfFree({0.0, 0.3, 2.0}, 0.1, "2: 2.00 m^2")) << "farther below";
  EXPECT_TRUE(overlap_filter.addIfFree({0.8, 0.0, 2.0}, 0.1, "3: 2.00 m^2")) << "farther to the right";
  EXPECT_FALSE(overlap_filter.addIfFree({0.8, 0.0, 2.0}, 0.1, "4"))
      << "those that are reserved later count as well";
}

TEST(TextOverlapFilter, doesNotCareBehindTheCamera) {
  TextOverlapFilter overlap_filter(kCamera);
  EXPECT_TRUE(overlap_filter.addIfFree({0.0, 0.0, -2.0}, 0.1, "1"));
  EXPECT_TRUE(overlap_filter.addIfFree({0.0, 0.0, 0.0}, 0.1, "1"));
  EXPECT_TRUE(overlap_filter.addIfFree({0.0, 0.0, 2.0}, 0.1, "2"));
}

}  // namespace
}  // namespace line_plane_segmentation
