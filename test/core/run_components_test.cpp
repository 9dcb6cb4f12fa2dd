// SPDX-License-Identifier: BSD-3-Clause
#include "planes/run_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/row_kernels.h"
#include "support/flood_fill.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

/// Which pixels take part, and which neighbours are linked, at random.
struct Mesh {
  int width, height;
  std::vector<std::uint8_t> mask, links;

  Mesh(int w, int h, double members, double linked, Random& random) : width(w), height(h) {
    for (int i = 0; i < w * h; ++i) {
      mask.push_back(random.chance(members) ? 1 : 0);
      links.push_back(static_cast<std::uint8_t>((random.chance(linked) ? kLinkRight : 0) |
                                                (random.chance(linked) ? kLinkDown : 0)));
    }
  }

  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
  bool isMember(int u, int v) const { return mask[index(u, v)] != 0; }
  bool isLinked(int u0, int v0, int u1, int v1) const {
    const std::uint8_t bit = v0 == v1 ? kLinkRight : kLinkDown;
    return (links[index(std::min(u0, u1), std::min(v0, v1))] & bit) != 0;
  }
  std::vector<std::uint8_t> regionOf(int u, int v) const {
    return floodFill(
        width, height, u, v, [this](int a, int b) { return isMember(a, b); },
        [this](int a, int b, int c, int d) { return isLinked(a, b, c, d); });
  }

  void addTo(RunComponents& components) const {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width;) {
        PixelRun run{v, u, u + 1};
        u = run.last;
        if (!isMember(run.first, v)) continue;
        while (u < width && isMember(u, v) && isLinked(u - 1, v, u, v)) run.last = ++u;
        components.add(run, v > 0 ? links.data() + index(0, v - 1) : nullptr);
      }
    }
  }
};

std::vector<std::uint8_t> pixelsOf(const std::vector<PixelRun>& runs, const Mesh& mesh) {
  std::vector<std::uint8_t> pixels(mesh.mask.size(), 0);
  for (const PixelRun& run : runs) {
    for (int u = run.first; u < run.last; ++u) ++pixels[mesh.index(u, run.row)];
  }
  return pixels;
}

TEST(RunComponents, AreTheRegionsOfAFloodFill) {
  RunComponents components;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const Mesh mesh(random.integer(1, 40), random.integer(1, 30), random.uniform(0.3, 1.0),
                    random.uniform(0.3, 1.0), random);
    components.clear();
    mesh.addTo(components);
    for (int k = 0; k < 30; ++k) {
      const int u = random.integer(0, mesh.width - 1), v = random.integer(0, mesh.height - 1);
      const int component = components.componentAt(u, v);
      ASSERT_EQ(component >= 0, mesh.isMember(u, v)) << seed;
      if (component < 0) continue;
      const std::vector<std::uint8_t> region = mesh.regionOf(u, v);
      ASSERT_EQ(components.pixelCount(component), std::count(region.begin(), region.end(), 1)) << seed;
      ASSERT_EQ(pixelsOf(components.runsOf(component), mesh), region) << seed;
    }
  }
}

TEST(RunComponents, OfOneRegionHaveOneNumber) {
  Random random(1);
  const Mesh mesh(30, 20, 0.8, 0.7, random);
  RunComponents components;
  mesh.addTo(components);
  for (int v = 0; v < mesh.height; ++v) {
    for (int u = 0; u < mesh.width; ++u) {
      if (!mesh.isMember(u, v)) continue;
      const std::vector<std::uint8_t> region = mesh.regionOf(u, v);
      for (int i = 0; i < mesh.width * mesh.height; ++i) {
        const bool is_same =
            components.componentAt(i % mesh.width, i / mesh.width) == components.componentAt(u, v);
        ASSERT_EQ(is_same, region[static_cast<std::size_t>(i)] != 0);
      }
    }
  }
}

TEST(RunComponents, AreJoinedWhereTwoArmsMeetBelow) {
  const std::uint8_t all[] = {3, 3, 3, 3, 3};
  RunComponents components;
  components.add({4, 0, 1}, all);
  components.add({4, 4, 5}, all);
  EXPECT_NE(components.componentAt(0, 4), components.componentAt(4, 4));
  components.add({5, 0, 5}, all);
  EXPECT_EQ(components.componentAt(0, 4), components.componentAt(4, 4));
  EXPECT_EQ(components.pixelCount(components.componentAt(2, 5)), 7);
}

TEST(RunComponents, AreNotJoinedOverASkippedRowOrADiagonal) {
  const std::uint8_t all[] = {3, 3, 3, 3, 3};
  RunComponents components;
  components.add({2, 0, 3}, all);
  components.add({4, 0, 3}, all);
  components.add({5, 3, 5}, all);
  EXPECT_NE(components.componentAt(0, 2), components.componentAt(0, 4));
  EXPECT_NE(components.componentAt(2, 4), components.componentAt(3, 5));
}

TEST(RunComponents, AreNoneAtFirstAndAfterClear) {
  RunComponents components;
  EXPECT_EQ(components.componentAt(0, 0), -1);
  components.add({0, 0, 5}, nullptr);
  EXPECT_EQ(components.componentAt(4, 0), 0);
  EXPECT_EQ(components.componentAt(5, 0), -1);
  EXPECT_EQ(components.componentAt(0, 1), -1);
  components.clear();
  EXPECT_EQ(components.componentAt(0, 0), -1);
}

}  // namespace
}  // namespace line_plane_segmentation
