// SPDX-License-Identifier: BSD-3-Clause
// The slowest images that scripts/find_slow_images found, as multiples of a room's time in the same process.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "quality/slow_images.h"

namespace line_plane_segmentation {
namespace {

constexpr int kRuns = 2;
constexpr int kRepetitions = 6;

using Kind = PatternKind;

struct Case {
  const char* preset;
  double most;  // times a room's time
};

class BoundedWork : public testing::TestWithParam<Case> {};

TEST_P(BoundedWork, NoImageTakesManyTimesAsLongAsARoom) {
  Parameters parameters;
  ASSERT_TRUE(loadPreset(GetParam().preset, parameters));
  SlowImages images(parameters);
  for (const Pattern& pattern : {Pattern{Kind::kSpiral, 3, 1},
                                 Pattern{Kind::kSpiral, 24, 1},
                                 Pattern{Kind::kSquareSpiral, 3, 1},
                                 Pattern{Kind::kColumnComb, 2, 1},
                                 Pattern{Kind::kColumnComb, 2, 1, 100, 3},
                                 Pattern{Kind::kColumnComb, 5, 1},
                                 Pattern{Kind::kRowComb, 2, 1},
                                 Pattern{Kind::kDots, 2, 1},
                                 Pattern{Kind::kSpeckle, 2, 1},
                                 Pattern{Kind::kSpeckle, 17, 7, 100, 3},
                                 Pattern{Kind::kSpeckle, 16, 6, 196, 1},
                                 Pattern{Kind::kCarpet, 4, 2},
                                 Pattern{Kind::kChecker, 8, 1},
                                 Pattern{Kind::kStripes, 9, 6, 186, 3},
                                 Pattern{Kind::kStripes, 12, 6, 100},
                                 Pattern{Kind::kRidges, 10, 1, 80},
                                 Pattern{Kind::kPyramids, 3, 1, 288, 1},
                                 Pattern{Kind::kPyramids, 24, 1, 190},
                                 Pattern{Kind::kStairs, 6, 1, 150},
                                 Pattern{Kind::kWaves, 6, 3, 177, 2},
                                 Pattern{Kind::kNoise, 2, 1, 300}}) {
    const std::vector<std::uint16_t> depth = SlowImages::draw(pattern);
    double times = images.timesOfRoom(depth, kRuns);
    // Other programs may have slowed down one of the two.
    for (int i = 0; i < kRepetitions && times >= GetParam().most; ++i)
      times = std::min(times, images.timesOfRoom(depth, kRuns));
    std::cout << times << " times: " << pattern.name() << '\n';
    EXPECT_LT(times, GetParam().most) << pattern.name();
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, BoundedWork,
                         testing::Values(Case{"kinect", 3.0}, Case{"paper", 4.0}, Case{"short_range", 7.0}),
                         [](const auto& preset) { return std::string(preset.param.preset); });

}  // namespace
}  // namespace line_plane_segmentation
