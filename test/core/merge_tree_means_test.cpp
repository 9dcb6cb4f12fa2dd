// SPDX-License-Identifier: BSD-3-Clause
// The moments that the clusters of merge_tree.h keep of their candidates; the rest is tested in
// merge_tree_test.cpp.
#include <gtest/gtest.h>

#include <cstddef>

#include "planes/merge_tree.h"
#include "support/clustered_image.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;

CandidateImage candidatesOf(const Surface& surface) {
  Random random(5);
  DepthImage depth = render(surface, kinectCamera(kWidth, kHeight), kWidth, kHeight);
  addNoise({}, 1.0, random, depth);
  return {depth, adaptiveParameters(kWidth)};
}

void grow(const CandidateImage& image, MergeTree& tree) {
  tree.start(image.grid, stepTolerance(adaptiveParameters(kWidth)));
  tree.mergeLinked(image.grid.links, 4.4, {1.0 / 16, 1.0});
}

// Of small clusters, whose moments are summed when they are asked for, and of those that store them; also
// after the tree was used for another image.
TEST(MergeTree, MeansAreTheMomentsOfTheCandidatesMeanPoints) {
  const CandidateImage before = candidatesOf(surfaceAt(1.5)), image = candidatesOf(surfaceAt(2.0, 0.4));
  MergeTree tree;
  grow(before, tree);
  grow(image, tree);
  int small = 0, large = 0;
  for (int i = 0; i < tree.size(); ++i) {
    double weight = 0.0, x_rho = 0.0, yy = 0.0;
    for (const int k : tree.candidatesOf(i)) {
      const CrossingCandidate& candidate = image.grid.candidates[static_cast<std::size_t>(k)];
      const double w = candidate.inv_tolerance * candidate.inv_tolerance;
      weight += w;
      x_rho += w * candidate.x * candidate.rho;
      yy += w * candidate.y * candidate.y;
    }
    const RegressionMoments means = tree.means(i);
    EXPECT_EQ(means.pixels, tree.node(i).candidates);
    EXPECT_NEAR(means.weight, weight, 1e-9 * weight);
    EXPECT_NEAR(means.x_rho, x_rho, 1e-9 * weight);
    EXPECT_NEAR(means.yy, yy, 1e-9 * weight);
    (tree.node(i).candidates < kMinCompared ? small : large) += 1;
  }
  EXPECT_GT(small, tree.leaves());
  EXPECT_GT(large, 10);
}

}  // namespace
}  // namespace line_plane_segmentation
