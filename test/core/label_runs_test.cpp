// SPDX-License-Identifier: BSD-3-Clause
#include "refine/label_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/random.h"

namespace line_plane_segmentation {
namespace {

using Labels = std::vector<std::uint16_t>;

/// A label image of blotches and single odd pixels.
struct LabelImage {
  int width, height;
  Labels labels;

  explicit LabelImage(Random& random) : width(random.integer(1, 70)), height(random.integer(1, 20)) {
    for (int i = 0; i < width * height; ++i) {
      const bool stays = i > 0 && random.chance(0.75);
      const int any = random.integer(0, 4);
      labels.push_back(stays ? labels.back() : static_cast<std::uint16_t>(any == 4 ? kNoDepthLabel : any));
    }
  }
  std::uint16_t at(int u, int v) const { return labels[static_cast<std::size_t>(v * width + u)]; }
};

/// Expects runs that cover every pixel once, in order, row by row.
void expectComplete(const LabelRuns& image, int width, int height) {
  ASSERT_EQ(image.row_begin.size(), static_cast<std::size_t>(height) + 1);
  ASSERT_EQ(image.row_begin.back(), image.runs.size());
  for (int v = 0; v < height; ++v) {
    int next = 0;
    for (std::size_t i = image.row_begin[static_cast<std::size_t>(v)];
         i < image.row_begin[static_cast<std::size_t>(v) + 1]; ++i) {
      ASSERT_EQ(image.runs[i].row, v);
      ASSERT_EQ(image.runs[i].first, next);
      ASSERT_GT(image.runs[i].pixels(), 0);
      next = image.runs[i].last;
    }
    ASSERT_EQ(next, width);
  }
}

bool hasEqualNeighbors(const LabelRuns& image) {
  for (std::size_t i = 1; i < image.runs.size(); ++i) {
    if (image.runs[i].row == image.runs[i - 1].row && image.runs[i].label == image.runs[i - 1].label)
      return true;
  }
  return false;
}

TEST(LabelRuns, AreTheImageAndBack) {
  LabelRuns runs;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const LabelImage image(random);
    runs.scan(image.labels, image.width, image.height);
    expectComplete(runs, image.width, image.height);
    ASSERT_FALSE(hasEqualNeighbors(runs)) << seed;
    Labels written(image.labels.size(), 99);
    runs.write(written, image.width);
    ASSERT_EQ(written, image.labels) << seed;
  }
}

TEST(LabelRuns, OfNothingAreNone) {
  LabelRuns runs;
  runs.scan({}, 0, 0);
  EXPECT_TRUE(runs.runs.empty());
  EXPECT_EQ(runs.row_begin, std::vector<std::size_t>{0});
  runs.join([](std::size_t, const LabelRun& run) { return run.label; });
  Labels labels;
  runs.write(labels, 0);
  forEachVerticalContact(runs, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(LabelRuns, AreJoinedWhereLabelsHaveBecomeEqual) {
  LabelRuns runs;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const LabelImage image(random);
    runs.scan(image.labels, image.width, image.height);
    Labels expected = image.labels;
    std::replace(expected.begin(), expected.end(), std::uint16_t{2}, std::uint16_t{1});
    const LabelRuns before = runs;
    runs.join([&before](std::size_t i, const LabelRun& run) {
      EXPECT_EQ(run.label, before.runs[i].label);
      return run.label == 2 ? std::uint16_t{1} : run.label;
    });
    LabelRuns anew;
    anew.scan(expected, image.width, image.height);
    expectComplete(runs, image.width, image.height);
    ASSERT_EQ(runs.row_begin, anew.row_begin) << seed;
    ASSERT_FALSE(hasEqualNeighbors(runs)) << seed;
  }
}

TEST(LabelRuns, TouchWhereTheyLieAboveEachOther) {
  LabelRuns runs;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const LabelImage image(random);
    runs.scan(image.labels, image.width, image.height);
    std::vector<std::vector<int>> visits(runs.runs.size(), std::vector<int>(runs.runs.size(), 0));
    forEachVerticalContact(runs, [&](std::size_t above, std::size_t below) { ++visits[above][below]; });
    for (std::size_t a = 0; a < runs.runs.size(); ++a) {
      for (std::size_t b = 0; b < runs.runs.size(); ++b) {
        const LabelRun &above = runs.runs[a], &below = runs.runs[b];
        const bool touch = below.row == above.row + 1 &&
                           std::max(above.first, below.first) < std::min(above.last, below.last);
        ASSERT_EQ(visits[a][b], touch ? 1 : 0) << seed;
      }
    }
  }
}

LabelRuns rowOf(const Labels& labels) {
  LabelRuns runs;
  runs.clear();
  runs.addRow(labels.data(), static_cast<int>(labels.size()));
  return runs;
}

Labels joined(const Labels& labels, int max_pixels) {
  LabelRuns runs = rowOf(labels);
  runs.joinOverSpeckles(max_pixels, [](const LabelRun&, const LabelRun&, const LabelRun&) { return true; });
  expectComplete(runs, static_cast<int>(labels.size()), 1);
  Labels written(labels.size());
  for (const LabelRun& run : runs.runs)
    std::fill(written.begin() + run.first, written.begin() + run.last, run.label);
  return written;
}

TEST(LabelRuns, JoinOverSpeckles) {
  const std::uint16_t none = kNoDepthLabel;
  EXPECT_EQ(joined({1, 1, 0, 1, 1}, 1), (Labels{1, 1, 1, 1, 1}));
  EXPECT_EQ(joined({1, 1, 0, 0, 1}, 2), (Labels{1, 1, 1, 1, 1}));
  EXPECT_EQ(joined({1, 1, 0, 0, 1}, 1), (Labels{1, 1, 0, 0, 1})) << "too wide";
  EXPECT_EQ(joined({1, 1, 2, 2, 1}, 3), (Labels{1, 1, 2, 2, 1})) << "another plane";
  EXPECT_EQ(joined({1, 0, 2}, 3), (Labels{1, 0, 2})) << "between two labels";
  EXPECT_EQ(joined({1, none, 1}, 3), (Labels{1, none, 1})) << "no depth there";
  EXPECT_EQ(joined({none, 0, none}, 3), (Labels{none, 0, none})) << "no depth around it";
  EXPECT_EQ(joined({0, 1, 0, 0}, 3), (Labels{0, 1, 0, 0})) << "a plane in none";
  EXPECT_EQ(joined({1, 0, 1, 0, 0, 1, 0, 1}, 2), (Labels{1, 1, 1, 1, 1, 1, 1, 1})) << "several in a row";
  EXPECT_EQ(joined({0, 1}, 3), (Labels{0, 1}));
  EXPECT_EQ(joined({7}, 3), (Labels{7}));
}

TEST(LabelRuns, JoinOverSpecklesOnlyIfTheyAreAlike) {
  LabelRuns runs = rowOf({1, 1, 0, 1, 0, 0, 1});
  std::vector<std::pair<int, int>> asked;
  runs.joinOverSpeckles(3, [&](const LabelRun& before, const LabelRun& speckle, const LabelRun& after) {
    EXPECT_EQ(before.last, speckle.first);
    EXPECT_EQ(speckle.last, after.first);
    asked.emplace_back(speckle.first, speckle.last);
    return speckle.first == 4;
  });
  EXPECT_EQ(asked, (std::vector<std::pair<int, int>>{{2, 3}, {4, 6}}));
  ASSERT_EQ(runs.runs.size(), 3U);
  EXPECT_EQ(runs.runs[2].first, 3);
  EXPECT_EQ(runs.runs[2].last, 7);
}

TEST(LabelRuns, JoinOverSpecklesInTheLastRowOnly) {
  LabelRuns runs = rowOf({1, 0, 1});
  const Labels second = {2, 0, 2};
  runs.addRow(second.data(), 3);
  runs.joinOverSpeckles(3, [](const LabelRun&, const LabelRun&, const LabelRun&) { return true; });
  EXPECT_EQ(runs.row_begin, (std::vector<std::size_t>{0, 3, 4}));
}

}  // namespace
}  // namespace line_plane_segmentation
