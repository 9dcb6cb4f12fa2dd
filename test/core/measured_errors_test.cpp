// SPDX-License-Identifier: BSD-3-Clause
// What the segmenter measures of the depth's errors: curvature of candidates, distortion of the image.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "support/median.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

// A wall that the sensor bends by 3 cm, 256 pixels from crest to crest.
TEST(MeasuredDistortion, KeepsABentWallWhole) {
  DepthImage depth = render(surfaceAt(2.0), kinectCamera(640, 480), 640, 480);
  const double phase = 2.0 * M_PI / 256.0;
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u)
      depth.row(v)[u] += static_cast<float>(0.03 * (std::sin(phase * u) + std::sin(phase * v)));
  }
  Random random(3);
  addNoise({}, 0.5, random, depth);
  const auto planes_at = [&depth](double noise_scale) {
    Parameters parameters;
    parameters.noise.scale = noise_scale;
    PlaneSegmenter segmenter(parameters);
    return segmenter.segment(viewOf(depth.z.data(), 640, 480), kinectCamera(640, 480)).planes.size();
  };
  EXPECT_LE(planes_at(0.0), 2U);
  EXPECT_GE(planes_at(1.0), 5U);
}

class CandidateCurvature : public testing::TestWithParam<Method> {};

TEST_P(CandidateCurvature, GrowsWithTheSquareOfTheNoise) {
  const auto median_at = [](double noise_factor) {
    DepthImage depth = render(surfaceAt(2.0, 0.3), kinectCamera(320, 240), 320, 240);
    Random random(5);
    addNoise({}, noise_factor, random, depth);
    Parameters parameters;
    parameters.method = GetParam();
    PlaneSegmenter segmenter(parameters);
    segmenter.segment(viewOf(depth.z.data(), 320, 240), kinectCamera(320, 240));
    std::vector<double> curvatures;
    for (const PlaneCandidate& candidate : segmenter.candidates()) {
      curvatures.push_back(candidate.curvature);
      EXPECT_TRUE(candidate.curvature >= 0.0 && candidate.curvature <= 1.0 / 3.0) << candidate.curvature;
    }
    return median(curvatures);
  };
  const double once = median_at(0.5);
  EXPECT_GT(once, 0.0);
  EXPECT_NEAR(median_at(1.0) / once, 4.0, 1.5);
  EXPECT_LT(median_at(0.0), 0.01 * once);
}

INSTANTIATE_TEST_SUITE_P(Methods, CandidateCurvature, testing::Values(Method::kPaper, Method::kAdaptive),
                         [](const auto& method) {
                           return method.param == Method::kPaper ? "Paper" : "Adaptive";
                         });

}  // namespace
}  // namespace line_plane_segmentation
