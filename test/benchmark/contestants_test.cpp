// SPDX-License-Identifier: BSD-3-Clause
#include "contestants.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>

#include "frame_sources.h"

namespace line_plane_segmentation {
namespace {

std::vector<std::string> namesOf(const std::vector<Contestant>& methods) {
  std::vector<std::string> names;
  for (const Contestant& method : methods) names.push_back(method.name);
  return names;
}

// Two large planes apart are found by whatever is called a method, from whatever it makes of the depth image;
// also with a part of the image missing, and again after other frames.
TEST(Contestants, AllFindTwoPlanes) {
  constexpr int kNanBytes = 0xff;
  mallopt(M_PERTURB, kNanBytes);  // what is read after its memory was freed is no number
  BenchmarkFrame two = simulatedTiles(2, 320, 240);
  std::fill_n(two.depth.begin(), 320 * 20, std::uint16_t{0});
  const BenchmarkFrame one = simulatedTiles(1, 320, 240);
  for (const Contestant& method : allContestants()) {
    for (int round = 0; round < 2; ++round) {
      method.engine->load(two);
      EXPECT_EQ(method.engine->segment(), 2) << method.name;
      method.engine->load(one);
      EXPECT_EQ(method.engine->segment(), 1) << method.name;
    }
  }
}

TEST(Contestants, NoneFindsAPlaneWhereThereIsNoDepth) {
  BenchmarkFrame frame = simulatedTiles(1, 320, 240);
  std::fill(frame.depth.begin(), frame.depth.end(), std::uint16_t{0});
  for (const Contestant& method : allContestants()) {
    method.engine->load(frame);
    EXPECT_EQ(method.engine->segment(), 0) << method.name;
  }
}

TEST(Contestants, AreChosenByName) {
  EXPECT_EQ(namesOf(contestants({"omps", "adaptive"})), (std::vector<std::string>{"adaptive", "omps"}));
}

TEST(Contestants, OnlyThisPackagesTellTheirStages) {
  for (const Contestant& method : contestants({"adaptive", "paper_1", "omps"})) {
    EXPECT_EQ(method.engine->stageTimes() != nullptr, method.name != "omps") << method.name;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
