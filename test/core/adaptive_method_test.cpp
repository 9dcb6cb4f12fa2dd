// SPDX-License-Identifier: BSD-3-Clause
// The noise model and the tolerances that the default method adapts to an image.
#include "methods/adaptive_method.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 640, kHeight = 480;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

/// Factors of the noise model and of the tolerance of candidates.
struct Adaptation {
  double noise, distortion;
};

/// @param noise_factor      noise of the image, as a multiple of the model
/// @param wave              [m] height of waves, 256 pixels from crest to crest
/// @param scanline_spacing  [px] 0 for the default
Adaptation adaptationTo(double noise_factor, double wave, int scanline_spacing = 0) {
  Frame frame;
  frame.camera = kCamera;
  frame.kinect_width = kWidth;
  frame.depth = render(surfaceAt(2.0), kCamera, kWidth, kHeight);
  frame.rays = raysOf(kCamera, kWidth, kHeight);
  const double phase = 2.0 * M_PI / 256.0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u)
      frame.depth.row(v)[u] += static_cast<float>(wave * (std::sin(phase * u) + std::sin(phase * v)));
  }
  Random random(5);
  addNoise({}, noise_factor, random, frame.depth);
  Parameters given;
  given.scanlines.scanline_spacing = scanline_spacing;
  const Parameters before = resolve(given, kWidth);
  frame.parameters = before;
  AdaptiveMethod().extractLines(frame);
  const Parameters& after = frame.parameters;
  const Adaptation adaptation = {after.noise.floor / before.noise.floor,
                                 after.patches.patch_noise_factor / before.patches.patch_noise_factor};
  EXPECT_NEAR(after.noise.growth / before.noise.growth, adaptation.noise, 1e-9);
  EXPECT_NEAR(before.clusters.max_curvedness / after.clusters.max_curvedness,
              adaptation.distortion * adaptation.distortion, 1e-9);
  return adaptation;
}

TEST(AdaptiveMethod, MultipliesTheNoiseModelByOneToFour) {
  EXPECT_EQ(adaptationTo(0.0, 0.0).noise, 1.0);
  EXPECT_EQ(adaptationTo(30.0, 0.0).noise, 4.0);
}

// The ratio of distortion to noise is the factor up to 2. From 4 on it measures clutter, and the factor falls
// back to 1.
TEST(AdaptiveMethod, MultipliesTheTolerancesByOneToTwo) {
  EXPECT_EQ(adaptationTo(0.5, 0.0).distortion, 1.0);
  EXPECT_EQ(adaptationTo(0.5, 0.04).distortion, 2.0) << "three to four times the noise";
  EXPECT_EQ(adaptationTo(0.5, 0.1).distortion, 1.0) << "more than five times";
}

// Finer scanlines have shorter windows, over which the same distortion would look smaller.
TEST(AdaptiveMethod, MeasuresTheSameDistortionOnFinerScanlines) {
  const double distortion = adaptationTo(0.5, 0.02).distortion;
  EXPECT_GT(distortion, 1.2);
  EXPECT_LT(distortion, 1.9);
  for (const int spacing : {7, 8, 10, 16})
    EXPECT_NEAR(adaptationTo(0.5, 0.02, spacing).distortion / distortion, 1.0, 0.15) << spacing;
}

}  // namespace
}  // namespace line_plane_segmentation
