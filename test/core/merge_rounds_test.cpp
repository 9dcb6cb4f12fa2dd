// SPDX-License-Identifier: BSD-3-Clause
// The order in which candidates are merged to planes; the rest of plane_clustering.h is tested in
// plane_clustering_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "planes/plane_clustering.h"
#include "support/made_candidates.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kSide = 5;  // candidates in a row and in a column of each plane

/// Two planes that meet at a sharp crease, and a single candidate between them.
/// @param left, right  cost of merging the single candidate with either plane
MadeCandidates twoPlanesAndOne(double left, double right) {
  // One candidate at this distance from the end of a plane adds its squared deviation over 1.22: the sum of 1
  // for itself, 1 / 25 for the plane's mean and 9 / 50 for its slope.
  const double from_left = std::sqrt(1.22 * left), from_right = std::sqrt(1.22 * right);
  MadeCandidates made(2 * kSide + 1, kSide);
  for (int distance = 1; distance <= kSide; ++distance) {
    for (int row = 0; row < kSide; ++row) {
      made.add(kSide - distance, row, 0.0);
      made.add(kSide + distance, row, from_left + from_right + 100.0 * distance);
    }
  }
  made.add(kSide, kSide / 2, from_left);
  made.linkColumns(0, kSide);
  made.linkColumns(kSide + 1, 2 * kSide + 1);
  made.link(kSide, kSide / 2, kSide + 1, kSide / 2);  // this link comes first
  made.link(kSide, kSide / 2, kSide - 1, kSide / 2);
  return made;
}

/// Whether the single candidate is merged with the left plane.
/// @param left, right  what that costs, and what merging with the right plane costs [merge_cost]
bool joinsTheLeft(double left, double right) {
  Parameters parameters = adaptiveParameters(320);
  parameters.clusters.coplanar_cost = 0.0;
  const double unit = parameters.clusters.merge_cost;
  const MadeCandidates made = twoPlanesAndOne(left * unit, right * unit);
  std::vector<PlaneCluster> clusters;
  std::vector<int> cluster_at;
  PlaneClusterer().cluster(blankDepth(0, 0), {}, made, parameters, 1.0, clusters, cluster_at);
  EXPECT_EQ(clusters.size(), 2U);
  const auto at = [&](int column) {
    return cluster_at[static_cast<std::size_t>(made.indexOf(column, kSide / 2))];
  };
  EXPECT_NE(at(kSide - 1), at(kSide + 1));
  return at(kSide) == at(kSide - 1);
}

TEST(MergeRounds, MergeWhatCostsLeastFirst) {
  for (const double fraction : {1.0 / 64, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0})
    EXPECT_TRUE(joinsTheLeft(0.8 * fraction, 1.25 * fraction)) << fraction;
}

TEST(MergeRounds, TakeLinksInTheirOrder) { EXPECT_FALSE(joinsTheLeft(0.6, 0.8)); }

}  // namespace
}  // namespace line_plane_segmentation
