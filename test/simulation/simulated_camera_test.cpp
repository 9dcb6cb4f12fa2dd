// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace line_plane_segmentation::simulation {
namespace {

using Image = std::vector<std::uint16_t>;

Image capture(SimulatedCamera& camera, std::uint64_t frame, double seconds) {
  const SimulatedCamera::Options& options = camera.options();
  Image mm(static_cast<std::size_t>(options.width * options.height));
  camera.capture(frame, seconds, mm.data());
  return mm;
}

TEST(SimulatedCamera, FramesDependOnSeedNumberAndTimeAlone) {
  SimulatedCamera camera({3, 320, 240, true});
  const Image image = capture(camera, 40, 1.5);
  capture(camera, 41, 1.6);
  EXPECT_EQ(capture(camera, 40, 1.5), image);
  SimulatedCamera same({3, 320, 240, true});
  EXPECT_EQ(capture(same, 40, 1.5), image);
  EXPECT_NE(capture(camera, 41, 1.5), image);
  EXPECT_NE(capture(camera, 40, 1.6), image);
  SimulatedCamera other({4, 320, 240, true});
  EXPECT_NE(capture(other, 40, 1.5), image);
}

TEST(SimulatedCamera, WorksInAnySize) {
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{160, 120}, {641, 479}, {1920, 1080}, {1, 1}, {1, 90}}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    SimulatedCamera camera({1, width, height, true});
    Image mm(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 65535);
    const Rendering& truth = camera.capture(0, 0.0, mm.data());
    EXPECT_EQ(truth.width, width);
    EXPECT_EQ(truth.height, height);
    EXPECT_EQ(truth.labels.size(), mm.size());
    EXPECT_EQ(std::count(mm.begin(), mm.end(), 65535), 0) << "pixels that were not written";
    if (width >= 160) {
      EXPECT_LT(std::count(mm.begin(), mm.end(), 0), static_cast<long>(mm.size() / 5));
    }
    EXPECT_NEAR(camera.intrinsics().fx / width, 525.0 / 640.0, 1e-12);
    EXPECT_NEAR(camera.intrinsics().cy, 0.5 * (height - 1), 1e-12);
  }
}

// The measured depth is that of the truth, but for noise: three deviations of Eq. 5 hold 99.7 %.
TEST(SimulatedCamera, DepthFollowsItsTruth) {
  SimulatedCamera camera({2, 640, 480, true});
  Image mm(640 * 480);
  const Rendering& truth = camera.capture(5, 2.0, mm.data());
  const NoiseParameters noise;
  int measured = 0;
  int near_truth = 0;
  for (std::size_t i = 0; i < mm.size(); ++i) {
    if (mm[i] == 0) continue;
    ASSERT_GT(truth.depth[i], 0.0F);
    ++measured;
    const double z = static_cast<double>(truth.depth[i]);
    near_truth += std::abs(1e-3 * mm[i] - z) < 3.0 * noise.sigma(z) + 0.0005 ? 1 : 0;
  }
  EXPECT_GT(measured, 640 * 480 * 8 / 10);
  EXPECT_GT(near_truth, measured * 0.995);
  EXPECT_LT(near_truth, measured);
}

TEST(SimulatedCamera, WithoutNoiseIsExact) {
  SimulatedCamera camera({2, 160, 120, false});
  Image mm(160 * 120);
  const Rendering& truth = camera.capture(5, 2.0, mm.data());
  for (std::size_t i = 0; i < mm.size(); ++i) {
    ASSERT_NEAR(1e-3 * mm[i], static_cast<double>(truth.depth[i]), 0.000501);
  }
}

TEST(SimulatedCamera, RefusesImpossibleSizes) {
  for (const int side : {0, -1, kMaxImageSide + 1}) {
    EXPECT_THROW(SimulatedCamera({1, side, 10, true}), std::invalid_argument);
    EXPECT_THROW(SimulatedCamera({1, 10, side, true}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace line_plane_segmentation::simulation
