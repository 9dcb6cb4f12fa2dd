// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>

#include "frame_sources.h"

namespace line_plane_segmentation {
namespace {

std::vector<std::string> namesOf(const std::vector<BenchmarkMethod>& methods) {
  std::vector<std::string> names;
  for (const BenchmarkMethod& method : methods) names.push_back(method.name);
  return names;
}

// Two large planes apart are found by whatever is called a method, from whatever it makes of the depth image;
// also with a part of the image missing, and again after other frames.
TEST(Methods, AllFindTwoPlanes) {
  constexpr int kNanBytes = 0xff;
  mallopt(M_PERTURB, kNanBytes);  // what is read after its memory was freed is no number
  BenchmarkFrame two = simulatedTiles(2, 320, 240);
  std::fill_n(two.depth.begin(), 320 * 20, std::uint16_t{0});
  const BenchmarkFrame one = simulatedTiles(1, 320, 240);
  for (const BenchmarkMethod& method : allMethods()) {
    for (int round = 0; round < 2; ++round) {
      method.engine->load(two);
      EXPECT_EQ(method.engine->segment(), 2) << method.name;
      method.engine->load(one);
      EXPECT_EQ(method.engine->segment(), 1) << method.name;
    }
  }
}

TEST(Methods, NoneFindsAPlaneWhereThereIsNoDepth) {
  BenchmarkFrame frame = simulatedTiles(1, 320, 240);
  std::fill(frame.depth.begin(), frame.depth.end(), std::uint16_t{0});
  for (const BenchmarkMethod& method : allMethods()) {
    method.engine->load(frame);
    EXPECT_EQ(method.engine->segment(), 0) << method.name;
  }
}

TEST(Methods, AreChosenByName) {
  EXPECT_EQ(namesOf(selectMethods({"omps", "adaptive"})), (std::vector<std::string>{"adaptive", "omps"}));
}

TEST(Methods, OnlyThisPackagesTellTheirStages) {
  for (const BenchmarkMethod& method : selectMethods({"adaptive", "paper_1", "omps"})) {
    EXPECT_EQ(method.engine->stageTimes() != nullptr, method.name != "omps") << method.name;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
