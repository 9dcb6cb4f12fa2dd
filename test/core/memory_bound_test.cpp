// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/allocation_counter.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// An image whose pixel (u, v) has depth_at(u, v) [mm].
template <typename Function>
std::vector<std::uint16_t> image(int width, int height, Function&& depth_at) {
  std::vector<std::uint16_t> pixels;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) pixels.push_back(static_cast<std::uint16_t>(depth_at(u, v)));
  }
  return pixels;
}

/// Images that need much memory with one preset or another.
std::vector<std::vector<std::uint16_t>> hungryImages(int width, int height) {
  const auto chessboard = [](int u, int v) { return (u + v) % 2 == 0 ? 0 : 1500 + u; };
  const auto columns = [](int u, int) { return u % 2 == 0 ? 0 : 1500 + u; };
  const auto pyramids = [](int u, int v) {
    return 1500 + u + 96 * std::max(std::abs(u % 6 - 3), std::abs(v % 6 - 3));
  };
  const auto squares = [](int u, int v) { return 1500 + u + (u / 12 + v / 12) % 2 * 113; };
  return {image(width, height, chessboard), image(width, height, columns), image(width, height, pyramids),
          image(width, height, squares)};
}

/// Ridges of six pixels on a slope, which need most with the paper's method.
std::vector<std::uint16_t> ridges(int width, int height) {
  return image(width, height, [](int u, int) { return 1500 + 3 * u + 81 * std::abs(u % 6 - 3); });
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

/// The most memory that an image needs, per pixel.
double bytesPerPixel(const Parameters& parameters, const std::vector<std::uint16_t>& pixels, int width,
                     int height, const CameraIntrinsics& camera) {
  std::unique_ptr<PlaneSegmenter> segmenter;
  const long peak = peakOf([&] {
    segmenter = std::make_unique<PlaneSegmenter>(parameters);
    for (int i = 0; i < 2; ++i) segmenter->segment(viewOf(pixels.data(), width, height), camera);
  });
  const double bytes = static_cast<double>(peak) / (width * height);
  std::cout << width << " pixels wide: " << bytes << " bytes a pixel\n";
  return bytes;
}

struct MemoryBound {
  const char* preset;
  double bytes_per_pixel, of_ridges;
  double after_simpler;  // room to grow again
};

class AnyImage : public testing::TestWithParam<MemoryBound> {};

TEST_P(AnyImage, NeedsSoManyBytesAPixel) {
  Parameters parameters;
  ASSERT_TRUE(loadPreset(GetParam().preset, parameters));
  for (const int width : {320, 640, 1280}) {
    const int height = width * 3 / 4;
    const CameraIntrinsics camera = kinectCamera(width, height);
    const auto needed = [&](const std::vector<std::uint16_t>& pixels) {
      return bytesPerPixel(parameters, pixels, width, height, camera);
    };
    std::vector<std::vector<std::uint16_t>> images = hungryImages(width, height);
    images.push_back(noiseRoundAPlane(width, height));
    for (const std::vector<std::uint16_t>& pixels : images)
      EXPECT_LT(needed(pixels), GetParam().bytes_per_pixel) << width;
    EXPECT_LT(needed(ridges(width, height)), GetParam().of_ridges) << width;
  }
}

// Images that need a little more each than the one before: what grows must not grow to twice the size.
TEST_P(AnyImage, NeedsNoMoreAfterSimplerOnes) {
  Parameters parameters;
  ASSERT_TRUE(loadPreset(GetParam().preset, parameters));
  constexpr int kWidth = 640, kHeight = 480;
  std::vector<std::vector<std::uint16_t>> images;
  for (int rough_rows = kHeight * 3 / 4; rough_rows <= kHeight; rough_rows += kHeight / 20) {
    images.push_back(hungryImages(kWidth, kHeight)[2]);
    std::fill(images.back().begin() + kWidth * rough_rows, images.back().end(), std::uint16_t{1500});
  }
  std::unique_ptr<PlaneSegmenter> segmenter;
  const long peak = peakOf([&] {
    segmenter = std::make_unique<PlaneSegmenter>(parameters);
    for (const std::vector<std::uint16_t>& pixels : images)
      segmenter->segment(viewOf(pixels.data(), kWidth, kHeight), kinectCamera(kWidth, kHeight));
  });
  const double bytes = static_cast<double>(peak) / (kWidth * kHeight);
  std::cout << bytes << " bytes a pixel\n";
  EXPECT_LT(bytes, GetParam().after_simpler);
}

// A single row, which no scanline lies in: nothing is reserved for its segments.
TEST(ThinImage, NeedsNoMemoryForSegments) {
  constexpr int kWidth = 100000;
  const std::vector<std::uint16_t> pixels(kWidth, 1500);
  EXPECT_LT(bytesPerPixel({}, pixels, kWidth, 1, {525.0, 525.0, 0.5 * kWidth, 0.0}), 60.0);
}

INSTANTIATE_TEST_SUITE_P(Presets, AnyImage,
                         testing::Values(MemoryBound{"kinect", 27.3, 27.3, 28.8},
                                         MemoryBound{"short_range", 90.0, 90.0, 25.0},
                                         MemoryBound{"paper", 40.0, 50.0, 31.0}),
                         [](const auto& bound) { return std::string(bound.param.preset); });

}  // namespace
}  // namespace line_plane_segmentation
