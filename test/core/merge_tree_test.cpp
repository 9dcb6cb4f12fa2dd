// SPDX-License-Identifier: BSD-3-Clause
// Candidates at crossings of segments, and the tree of their merges.
#include "planes/merge_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/clustered_image.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

CandidateImage findCandidates(const DepthImage& depth) {
  return CandidateImage(depth, adaptiveParameters(kWidth));
}

DepthImage noisy(DepthImage depth, double factor) {
  Random random(5);
  addNoise({}, factor, random, depth);
  return depth;
}

TEST(CrossingDetector, FitsThePlaneAtEachCrossing) {
  const Surface wall = surfaceAt(1.9, 0.4, -0.2);
  const CandidateImage found = findCandidates(render(wall, kCamera, kWidth, kHeight));
  EXPECT_EQ(found.grid.candidates.size(), static_cast<std::size_t>(found.grid.crossings()));
  for (const CrossingCandidate& candidate : found.grid.candidates) {
    const PlaneCandidate described = candidate.describe();
    EXPECT_LT((described.normal - wall.normal).norm(), 1e-3);
    EXPECT_NEAR(described.d, wall.d, 1e-3);
    EXPECT_EQ(found.grid.candidate_at[static_cast<std::size_t>(candidate.cell)],
              static_cast<int>(&candidate - found.grid.candidates.data()));
  }
  const std::size_t expected = static_cast<std::size_t>((found.grid.columns - 1) * found.grid.rows +
                                                        found.grid.columns * (found.grid.rows - 1));
  EXPECT_EQ(found.grid.links.size(), expected) << "each crossing is linked to its neighbours";
}

TEST(CrossingDetector, LinksNothingAcrossAStep) {
  const CandidateImage found =
      findCandidates(noisy(halves(surfaceAt(1.4), surfaceAt(1.5), kCamera, kWidth, kHeight), 0.5));
  ASSERT_FALSE(found.grid.links.empty());
  for (const CandidateGrid::Link& link : found.grid.links) {
    const CrossingCandidate& a = found.grid.candidates[static_cast<std::size_t>(link.a)];
    const CrossingCandidate& b = found.grid.candidates[static_cast<std::size_t>(link.b)];
    EXPECT_EQ(std::abs(a.cell - b.cell) == 1, a.v == b.v);
    EXPECT_FALSE(std::min(a.u, b.u) < 152 && std::max(a.u, b.u) > 168) << a.u << ' ' << b.u;
  }
}

/// Whether the crossing of a row and a column of a wall is a candidate.
bool isCandidate(int row_pixels, int column_pixels) {
  const auto scanline = [](int pixels) {
    ScanlineSet set;
    set.window = 30;
    set.windows = 1;
    set.pixels = {15};
    set.segment_of = {0};
    LineSums sums;  // of a wall 2 m away
    for (int i = 0; i < pixels; ++i) sums = sums + LineSums{1, 0.01 * i, 1e-4 * i * i, 0.5, 5e-3 * i, 0.25};
    set.sums = {sums};
    return set;
  };
  CandidateGrid grid;
  CrossingDetector().detect(raysOf(kinectCamera(30, 30), 30, 30), scanline(row_pixels),
                            scanline(column_pixels), adaptiveParameters(kWidth), grid);
  return grid.candidates.size() == 1;
}

TEST(CrossingDetector, NeedsPixelsThatSpanAPlane) {
  EXPECT_TRUE(isCandidate(2, 2));
  EXPECT_TRUE(isCandidate(5, 5));
  EXPECT_FALSE(isCandidate(1, 1));
}

TEST(CrossingCandidate, HasACurvatureOfAtMostAThird) {
  CrossingCandidate candidate =
      findCandidates(render(surfaceAt(2.0), kCamera, kWidth, kHeight)).grid.candidates.at(0);
  EXPECT_NEAR(candidate.describe().curvature, 0.0, 1e-4);
  candidate.squared_error = 1e9;
  EXPECT_EQ(candidate.describe().curvature, 1.0 / 3.0);
}

/// A tree of the candidates of an image, merged up to a limit.
struct Tree : MergeTree {
  CandidateImage image;
  explicit Tree(const DepthImage& depth, double limit = 4.4) : image(findCandidates(depth)) {
    start(image.grid, stepTolerance(adaptiveParameters(kWidth)));
    mergeLinked(image.grid.links, limit, {1.0 / 16, 1.0 / 4, 1.0, 1.0});
  }

  std::vector<int> roots() const {
    std::vector<int> found;
    for (int i = 0; i < size(); ++i) {
      if (isRoot(i)) found.push_back(i);
    }
    return found;
  }
};

TEST(MergeTree, KeepsTheHistoryOfItsMerges) {
  Tree tree(noisy(render(surfaceAt(2.0), kCamera, kWidth, kHeight), 1.0));
  const std::vector<int> roots = tree.roots();
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(tree.size(), 2 * tree.leaves() - 1);
  std::vector<int> candidates = tree.candidatesOf(roots.front());
  std::sort(candidates.begin(), candidates.end());
  ASSERT_EQ(candidates.size(), static_cast<std::size_t>(tree.leaves()));
  for (int i = 0; i < tree.leaves(); ++i) {
    EXPECT_EQ(candidates[static_cast<std::size_t>(i)], i);
    EXPECT_EQ(tree.find(i), roots.front());
  }
  for (int i = tree.leaves(); i < tree.size(); ++i) {
    const MergeTree::Node &node = tree.node(i), &left = tree.node(node.left), &right = tree.node(node.right);
    EXPECT_EQ(node.candidates, left.candidates + right.candidates);
    EXPECT_NEAR(node.moments.pixels, left.moments.pixels + right.moments.pixels, 1e-9);
    EXPECT_GE(node.squared_error, left.squared_error + right.squared_error - 1e-6);
  }
}

TEST(MergeTree, MergesNothingAtLimitZero) {
  const Tree tree(noisy(render(surfaceAt(2.0), kCamera, kWidth, kHeight), 1.0), 0.0);
  EXPECT_EQ(tree.size(), tree.leaves());
}

TEST(MergeTree, CostIsTheAddedErrorPerPixelOfTheSmaller) {
  Tree tree(noisy(render(surfaceAt(2.0), kCamera, kWidth, kHeight), 1.0), 0.0);
  FittedPixels both;
  ASSERT_TRUE(tree.combine(0, 1, both));
  const MergeTree::Node &a = tree.node(0), &b = tree.node(1);
  const double added = both.squared_error - a.squared_error - b.squared_error;
  EXPECT_NEAR(tree.costOf(0, 1, both), added / std::min(a.moments.pixels, b.moments.pixels), 1e-12);
  EXPECT_EQ(tree.merge(0, 1, both), tree.leaves());
  EXPECT_EQ(tree.find(0), tree.leaves());
  EXPECT_EQ(tree.find(1), tree.leaves());
}

TEST(MergeTree, MergesPartsOfClustersOnceMore) {
  Tree tree(noisy(render(surfaceAt(2.0), kCamera, kWidth, kHeight), 1.0));
  for (int i = 0; i + 1 < tree.leaves(); i += 2) {
    FittedPixels both;
    ASSERT_TRUE(tree.combine(i, i + 1, both));
    const int merged = tree.merge(i, i + 1, both);
    EXPECT_EQ(tree.find(i), merged);
  }
}

/// As MergeTree::mergeLinked(), without what it remembers.
void mergeWithoutMemory(std::vector<CandidateGrid::Link> links, double limit, MergeTree& tree) {
  for (const double fraction : {1.0 / 16, 1.0 / 4, 1.0, 1.0}) {
    std::vector<CandidateGrid::Link> kept;
    for (const CandidateGrid::Link& link : links) {
      const auto [b, a] = std::minmax({tree.find(link.a), tree.find(link.b)});
      FittedPixels both;
      if (a == b || !tree.combine(a, b, both)) continue;
      const double cost = tree.costOf(a, b, both) / limit;
      if (cost < fraction && !tree.isTwoPlanes(a, b, both)) {
        tree.merge(a, b, both);
      } else if (cost <= 4.0) {
        kept.push_back(link);
      }
    }
    links = kept;
  }
}

void expectSameNodes(const MergeTree& tree, const MergeTree& other) {
  ASSERT_EQ(tree.size(), other.size());
  for (int i = 0; i < tree.size(); ++i) {
    EXPECT_EQ(tree.node(i).left, other.node(i).left);
    EXPECT_EQ(tree.node(i).right, other.node(i).right);
    EXPECT_EQ(tree.node(i).squared_error, other.node(i).squared_error);
    EXPECT_EQ(tree.isRoot(i), other.isRoot(i));
  }
}

TEST(MergeTree, RemembersComparisonsAndChangesNothing) {
  for (const double noise : {0.5, 1.0, 2.0}) {
    const DepthImage depth = halves(surfaceAt(1.8, 0.1), surfaceAt(1.8, -0.1), kCamera, kWidth, kHeight);
    const Tree tree(noisy(depth, noise));
    MergeTree other;
    other.start(tree.image.grid, stepTolerance(adaptiveParameters(kWidth)));
    mergeWithoutMemory(tree.image.grid.links, 4.4, other);
    expectSameNodes(tree, other);
    EXPECT_LT(tree.size(), 2 * tree.leaves() - 1) << "two planes are not merged";
  }
}

TEST(MergeTree, StartsAnew) {
  const Tree large(noisy(render(surfaceAt(2.0), kCamera, kWidth, kHeight), 1.0));
  const Tree small(noisy(render(surfaceAt(2.0), kinectCamera(100, 80), 100, 80), 1.0));
  const DepthTolerance tolerance = stepTolerance(adaptiveParameters(kWidth));
  MergeTree tree;
  for (const Tree* expected : {&large, &small, &large}) {
    tree.start(expected->image.grid, tolerance);
    EXPECT_EQ(tree.size(), tree.leaves());
    tree.mergeLinked(expected->image.grid.links, 4.4, {1.0 / 16, 1.0 / 4, 1.0, 1.0});
    expectSameNodes(tree, *expected);
  }
}

/// Merges the candidates left and right of a column to one cluster each, except those as near to it as
/// `left_out` pixels, and asks something about them.
template <typename Question>
bool askOfHalves(const DepthImage& depth, int border, int left_out, Question&& question) {
  MergeTree tree;
  const CandidateImage image = findCandidates(depth);
  tree.start(image.grid, stepTolerance(adaptiveParameters(kWidth)));
  int halves[2] = {-1, -1};
  for (int i = 0; i < tree.leaves(); ++i) {
    const int u = image.grid.candidates[static_cast<std::size_t>(i)].u;
    if (std::abs(u - border) < left_out) continue;
    int& half = halves[u < border ? 0 : 1];
    FittedPixels both;
    if (half >= 0) {
      EXPECT_TRUE(tree.combine(half, i, both));
    }
    half = half < 0 ? i : tree.merge(half, i, both);
  }
  return question(tree, halves[0], halves[1]);
}

bool areTwoPlanes(const DepthImage& depth, int border = kWidth / 2, int left_out = 0) {
  return askOfHalves(depth, border, left_out, [](MergeTree& tree, int left, int right) {
    FittedPixels both;
    EXPECT_TRUE(tree.combine(left, right, both));
    return tree.isTwoPlanes(left, right, both);
  });
}

/// A wall that is bent away from the camera at its ends, of which the columns from `first` on stand back.
DepthImage bent(double metres, int first = kWidth, double step = 0.0) {
  DepthImage depth = render(surfaceAt(2.5), kCamera, kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double bend = metres * std::pow((u - 160.0) / 160.0, 2);
      depth.row(v)[u] += static_cast<float>(bend + (u < first ? 0.0 : step));
    }
  }
  return noisy(depth, 0.3);
}

TEST(MergeTree, TellsTwoPlanesFromOneAndFromABentOne) {
  EXPECT_FALSE(areTwoPlanes(noisy(render(surfaceAt(2.5), kCamera, kWidth, kHeight), 0.3)));
  const auto pair = [](const Surface& left, const Surface& right) {
    return noisy(halves(left, right, kCamera, kWidth, kHeight), 0.3);
  };
  constexpr int kLeftOut = 12;
  EXPECT_TRUE(areTwoPlanes(pair(surfaceAt(2.5, 0.2), surfaceAt(2.56, 0.2)), kWidth / 2, kLeftOut));
  EXPECT_TRUE(areTwoPlanes(pair(surfaceAt(2.5, 0.15), surfaceAt(2.5, -0.15)), kWidth / 2, kLeftOut));
  EXPECT_FALSE(areTwoPlanes(bent(0.045))) << "as the sensor's distortion bends a wall";
}

// A quadric surface explains the bend, and with it the step. At the second border, the crossings between both
// sides belong to neither.
TEST(MergeTree, TellsAStepFromABend) {
  constexpr int kLeftOut = 5;
  for (const int border : {240, 245}) {
    EXPECT_FALSE(areTwoPlanes(bent(0.06), border, kLeftOut)) << border;
    EXPECT_TRUE(areTwoPlanes(bent(0.06, border, 0.05), border, kLeftOut)) << border;
    EXPECT_TRUE(areTwoPlanes(bent(0.06, border, -0.05), border, kLeftOut)) << border;
  }
  EXPECT_FALSE(areTwoPlanes(bent(0.06, 240, 0.05), 240, 15)) << "they are three crossings apart";
}

bool isLeftAPieceOfCurved(const DepthImage& depth, int border) {
  return askOfHalves(depth, border, 0,
                     [](MergeTree& tree, int left, int right) { return tree.isPieceOfCurved(left, right); });
}

TEST(MergeTree, TellsPiecesOfACurvedSurface) {
  constexpr int kNearerToTheLeft = 140;
  EXPECT_TRUE(isLeftAPieceOfCurved(bent(0.3), kNearerToTheLeft));
  EXPECT_FALSE(isLeftAPieceOfCurved(bent(0.3), kWidth - kNearerToTheLeft)) << "the larger one";
  EXPECT_FALSE(isLeftAPieceOfCurved(bent(0.0), kNearerToTheLeft)) << "one plane";
  const DepthImage crease = halves(surfaceAt(2.5, 0.3), surfaceAt(2.5, -0.3), kCamera, kWidth, kHeight);
  EXPECT_FALSE(isLeftAPieceOfCurved(noisy(crease, 0.3), kWidth / 2 - 5)) << "two planes";
  const DepthImage step = halves(surfaceAt(2.5), surfaceAt(2.7), kCamera, kWidth, kHeight);
  EXPECT_FALSE(isLeftAPieceOfCurved(noisy(step, 0.3), kWidth / 2 - 5)) << "two depths";
}

TEST(MergeTree, OfNothingIsNothing) {
  const CandidateGrid grid;
  MergeTree tree;
  tree.start(grid, {});
  tree.mergeLinked({}, 1.0, {1.0});
  EXPECT_EQ(tree.size(), 0);
}

}  // namespace
}  // namespace line_plane_segmentation
