// SPDX-License-Identifier: BSD-3-Clause
// The step in depth where two clusters of candidates meet.
#include "planes/depth_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include "support/clustered_image.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240, kBorder = 160;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

InverseDepthPlane planeOf(const Surface& surface) {
  const Eigen::Vector3d abc = -surface.normal / surface.d;
  return {abc.x(), abc.y(), abc.z()};
}

/// The steps of all rows from the candidates left of the middle to those right of it.
std::vector<double> stepsAcross(const DepthImage& depth, const Surface& left, const Surface& right) {
  const Parameters parameters = adaptiveParameters(kWidth);
  const CandidateImage image(depth, parameters);
  const CandidateGrid& grid = image.grid;
  const auto cluster_at = [&grid](int cell) {
    const int candidate = grid.candidate_at[static_cast<std::size_t>(cell)];
    return candidate < 0 ? -1 : grid.candidates[static_cast<std::size_t>(candidate)].u < kBorder ? 0 : 1;
  };
  std::vector<double> steps;
  for (int cell = 0; cell < grid.crossings(); ++cell) {
    for (int distance = 1; distance <= kMaxContactDistance; ++distance) {
      const int to = grid.cellBeside(cell, distance, 0);
      if (cluster_at(cell) != 0 || to < 0 || cluster_at(to) != 1) continue;
      const ClusterContact contact = contactBetween(grid, cell, to, 1, 0, cluster_at);
      EXPECT_EQ(contact.behind_from->cell, cell - 1);
      EXPECT_EQ(contact.behind_to->cell, to + 1);
      steps.push_back(stepAt(contact, planeOf(left), planeOf(right), stepTolerance(parameters)));
    }
  }
  return steps;
}

TEST(DepthStep, IsInTolerancesAndPositiveTowardsTheCamera) {
  const Surface near = surfaceAt(2.0), far = surfaceAt(2.1);
  const double rho = 0.5 * (1.0 / 2.0 + 1.0 / 2.1);
  const double expected = (1.0 / 2.0 - 1.0 / 2.1) / stepTolerance(adaptiveParameters(kWidth)).at(rho, rho);
  for (const auto& [left, right, sign] : {std::tuple(far, near, 1.0), std::tuple(near, far, -1.0)}) {
    const std::vector<double> steps = stepsAcross(halves(left, right, kCamera, kWidth, kHeight), left, right);
    ASSERT_GT(steps.size(), 5U);
    for (const double step : steps) EXPECT_NEAR(step, sign * expected, 0.02 * expected);
  }
}

TEST(DepthStep, IsOfTheSurfacesNotOfTheirFits) {
  const DepthImage depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
  const std::vector<double> steps = stepsAcross(depth, surfaceAt(2.0), surfaceAt(2.1));
  ASSERT_GT(steps.size(), 5U);
  for (const double step : steps) EXPECT_NEAR(step, 0.0, 0.02);
}

TEST(DepthStep, IsHalfwayBetweenBothCandidates) {
  const InverseDepthPlane left{0.02, 0.05, 0.0}, right{-0.03, 0.01, 0.0};  // moved to the candidates
  CrossingCandidate from, to;
  from.x = 0.2;
  from.y = -0.4;
  to.x = 0.4;
  to.y = -0.2;
  from.rho = to.rho = 0.5;
  const ClusterContact contact{&from, &to, &from, &to};
  const double rho = 0.5 + 0.1 * (0.02 + 0.05), other_rho = 0.5 - 0.1 * (-0.03 + 0.01);
  DepthTolerance tolerance = stepTolerance(adaptiveParameters(kWidth));
  tolerance.distance = 0.0;  // so that the tolerance is that of the noise
  const double expected = (other_rho - rho) / tolerance.along(0.5 * (rho + other_rho));
  EXPECT_NEAR(stepAt(contact, left, right, tolerance), expected, 1e-9);
}

TEST(DepthStep, StopsAtTheEdgeOfAClusterAndOfTheGrid) {
  const CandidateImage image(render(surfaceAt(2.0), kCamera, kWidth, kHeight), adaptiveParameters(kWidth));
  const ClusterContact contact = contactBetween(image.grid, 0, 1, 1, 0, [](int cell) { return cell; });
  EXPECT_EQ(contact.from->cell, 0);
  EXPECT_EQ(contact.to->cell, 1);
  EXPECT_EQ(contact.behind_from, contact.from) << "at the edge of the grid";
  EXPECT_EQ(contact.behind_to, contact.to) << "the next candidate is in another cluster";
}

MeanStep meanOf(const std::vector<double>& steps) {
  MeanStep mean;
  for (const double step : steps) mean.add(step);
  return mean;
}

TEST(MeanStep, IsAStepAboveOneToleranceAndThreeStandardErrors) {
  EXPECT_FALSE(MeanStep().isStep());
  EXPECT_FALSE(meanOf({0.9, 0.9, 0.9, 0.9, 0.9, 0.9}).isStep());
  EXPECT_TRUE(meanOf({1.1, 1.1, 1.1, 1.1, 1.1, 1.1}).isStep());
  EXPECT_TRUE(meanOf({-1.1, -1.1, -1.1, -1.1, -1.1, -1.1}).isStep());
  EXPECT_FALSE(meanOf({9.0, 9.0, 9.0, 9.0}).isStep()) << "too few contacts";
  EXPECT_FALSE(meanOf({-4.0, 7.0, -4.0, 7.0, -4.0, 7.0}).isStep()) << "they disagree";
  // The mean is 2, its standard error the standard deviation over sqrt(n - 1).
  EXPECT_FALSE(meanOf({0.4, 3.6, 0.4, 3.6, 0.4, 3.6}).isStep());
  EXPECT_TRUE(meanOf({0.6, 3.4, 0.6, 3.4, 0.6, 3.4}).isStep());
  EXPECT_FALSE(meanOf({0.0, 4.0, 0.0, 4.0, 0.0, 4.0, 0.0, 4.0}).isStep());
  EXPECT_TRUE(meanOf({0.0, 4.0, 0.0, 4.0, 0.0, 4.0, 0.0, 4.0, 0.0, 4.0, 0.0, 4.0}).isStep());
}

TEST(MeanStep, OfPartsIsThatOfAll) {
  MeanStep sum = meanOf({1.5, 2.5, 1.0});
  EXPECT_FALSE(sum.isStep());
  sum += meanOf({2.0, 2.5, 1.0});
  EXPECT_TRUE(sum.isStep());
  sum = meanOf({1.5, 1.5, 1.5, 1.5, 1.5});
  EXPECT_TRUE(sum.isStep());
  sum += meanOf({9.0, -4.0, 9.0, -4.0, 9.0});
  EXPECT_FALSE(sum.isStep()) << "the second part disagrees";
}

TEST(StepTolerance, IsTheNoiseOrThePlaneDistance) {
  Parameters parameters = adaptiveParameters(kWidth);
  parameters.extraction.plane_distance = 0.02;
  parameters.patches.patch_distance = 0.004;
  EXPECT_EQ(stepTolerance(parameters).distance, 0.02);
  EXPECT_EQ(stepTolerance(parameters).noise_factor, parameters.patches.patch_noise_factor);
  parameters.extraction.plane_distance = 0.001;
  EXPECT_EQ(stepTolerance(parameters).distance, 0.004);
}

}  // namespace
}  // namespace line_plane_segmentation
