// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "core/allocation_counter.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// Half of the pixels without depth, as the squares of a chessboard, or as columns of a slope.
std::vector<std::uint16_t> halfEmpty(bool columns, int width, int height) {
  std::vector<std::uint16_t> pixels;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u)
      pixels.push_back(static_cast<std::uint16_t>((columns ? u : u + v) % 2 == 0 ? 0 : 1500 + u));
  }
  return pixels;
}

/// Pyramids with sides of six pixels.
std::vector<std::uint16_t> pyramids(int width, int height) {
  std::vector<std::uint16_t> pixels;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const int steps = std::max(std::abs(u % 6 - 3), std::abs(v % 6 - 3));
      pixels.push_back(static_cast<std::uint16_t>(1500 + u + 96 * steps));
    }
  }
  return pixels;
}

/// Depth at random, where no pixel touches another, round a plane.
std::vector<std::uint16_t> noiseRoundAPlane(int width, int height) {
  Random random(3);
  std::vector<std::uint16_t> pixels;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const bool is_plane = 4 * std::abs(u - width / 2) < width && 4 * std::abs(v - height / 2) < height;
      pixels.push_back(is_plane ? std::uint16_t{1500}
                                : static_cast<std::uint16_t>(random.integer(500, 6000)));
    }
  }
  return pixels;
}

struct MemoryBound {
  const char* preset;
  double bytes_per_pixel;
};

class AnyImage : public testing::TestWithParam<MemoryBound> {};

// The images that were found to need most, of all sizes.
TEST_P(AnyImage, NeedsSoManyBytesAPixel) {
  Parameters parameters;
  ASSERT_TRUE(loadPreset(GetParam().preset, parameters));
  for (const int width : {320, 640, 1280}) {
    const int height = width * 3 / 4;
    for (const std::vector<std::uint16_t>& pixels :
         {halfEmpty(false, width, height), halfEmpty(true, width, height), pyramids(width, height),
          noiseRoundAPlane(width, height)}) {
      std::unique_ptr<PlaneSegmenter> segmenter;
      const long peak = peakOf([&] {
        segmenter = std::make_unique<PlaneSegmenter>(parameters);
        for (int i = 0; i < 2; ++i)
          segmenter->segment(viewOf(pixels.data(), width, height), kinectCamera(width, height));
      });
      EXPECT_LT(static_cast<double>(peak), GetParam().bytes_per_pixel * width * height) << width;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, AnyImage,
                         testing::Values(MemoryBound{"kinect", 40.0}, MemoryBound{"short_range", 90.0},
                                         MemoryBound{"paper", 40.0}),
                         [](const auto& bound) { return std::string(bound.param.preset); });

}  // namespace
}  // namespace line_plane_segmentation
