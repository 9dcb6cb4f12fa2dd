// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/depth_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace line_plane_segmentation {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const DepthRange kWide{0.0F, 1000.0F};

template <typename Pixel>
constexpr DepthType typeOf() {
  return sizeof(Pixel) == 2 ? DepthType::kUint16 : DepthType::kFloat32;
}

/// Pixels in memory as a driver may leave them: at an odd address, rows padded, either byte order.
template <typename Pixel>
class StoredImage {
 public:
  StoredImage(const std::vector<Pixel>& pixels, int width, int height, std::size_t offset,
              std::size_t padding, bool swap_bytes) {
    const std::size_t row = static_cast<std::size_t>(width) * sizeof(Pixel);
    view.step = row + padding;
    bytes_.assign(offset + view.step * static_cast<std::size_t>(height), 0xEE);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      std::uint8_t stored[sizeof(Pixel)];
      std::memcpy(stored, &pixels[i], sizeof(Pixel));
      const std::size_t v = i / static_cast<std::size_t>(width), u = i % static_cast<std::size_t>(width);
      for (std::size_t k = 0; k < sizeof(Pixel); ++k) {
        bytes_[offset + v * view.step + u * sizeof(Pixel) + k] =
            stored[swap_bytes ? sizeof(Pixel) - 1 - k : k];
      }
    }
    view.data = bytes_.data() + offset;
    view.width = width;
    view.height = height;
    view.type = typeOf<Pixel>();
    view.depth_unit = sizeof(Pixel) == 2 ? 0.001F : 1.0F;
    view.swap_bytes = swap_bytes;
  }

  DepthView view;

 private:
  std::vector<std::uint8_t> bytes_;
};

int depthsIn(const std::vector<float>& row) {
  return static_cast<int>(std::count_if(row.begin(), row.end(), [](float z) { return z > 0.0F; }));
}

std::vector<float> rowOf(const DepthView& view, int v, const DepthRange& range = kWide) {
  std::vector<float> depth(static_cast<std::size_t>(view.width), -1.0F);
  const int depths = loadRow(view, v, range, depth.data());
  EXPECT_EQ(depths, depthsIn(depth));
  return depth;
}

std::vector<float> columnOf(const DepthView& view, int u, const DepthRange& range = kWide) {
  std::vector<float> depth(static_cast<std::size_t>(view.height), -1.0F);
  const int depths = loadColumn(view, u, range, depth.data());
  EXPECT_EQ(depths, depthsIn(depth));
  return depth;
}

std::vector<std::uint16_t> somePixels(std::uint16_t) { return {0, 1, 500, 1234, 40000, 65535}; }
std::vector<float> somePixels(float) { return {0.0F, 0.001F, 0.5F, 1.234F, 40.0F, 65.535F}; }

template <typename Pixel>
class DepthViewStorage : public testing::Test {};
using PixelTypes = testing::Types<std::uint16_t, float>;
TYPED_TEST_SUITE(DepthViewStorage, PixelTypes);

TYPED_TEST(DepthViewStorage, EveryLayoutReadsTheSame) {
  const std::vector<float> expected = {0.0F, 0.001F, 0.5F, 1.234F, 40.0F, 65.535F};
  for (const std::size_t offset : {0U, 1U, 2U, 3U}) {
    for (const std::size_t padding : {0U, 1U, 6U, 64U}) {
      for (const bool swap_bytes : {false, true}) {
        const StoredImage<TypeParam> image(somePixels(TypeParam{}), 3, 2, offset, padding, swap_bytes);
        for (int v = 0; v < 2; ++v) {
          for (int u = 0; u < 3; ++u) {
            const std::size_t i = static_cast<std::size_t>(3 * v + u);
            EXPECT_FLOAT_EQ(rowOf(image.view, v)[static_cast<std::size_t>(u)], expected[i])
                << offset << ' ' << padding;
            EXPECT_FLOAT_EQ(columnOf(image.view, u)[static_cast<std::size_t>(v)], expected[i])
                << offset << ' ' << padding;
          }
        }
      }
    }
  }
}

TYPED_TEST(DepthViewStorage, NothingIsWrittenBesideTheRow) {
  const StoredImage<TypeParam> image(somePixels(TypeParam{}), 3, 2, 0, 0, false);
  std::vector<float> depth(5, -1.0F);
  loadRow(image.view, 0, kWide, depth.data() + 1);
  EXPECT_EQ(depth.front(), -1.0F);
  EXPECT_EQ(depth.back(), -1.0F);
}

TEST(DepthView, EveryNumberOfALongRowIsReadExactly) {
  std::vector<std::uint16_t> pixels(65536);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint16_t>(i);
  const DepthRange range{0.3F, 10.0F};
  for (const std::size_t offset : {0U, 1U}) {
    const StoredImage<std::uint16_t> image(pixels, 65536, 1, offset, 0, false);
    const std::vector<float> depth = rowOf(image.view, 0, range);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const float metres = static_cast<float>(i) * 0.001F;
      ASSERT_EQ(depth[i], metres > range.min && metres < range.max ? metres : 0.0F) << i;
    }
  }
}

TEST(DepthView, OnlyPositiveFiniteFloatsAreDepths) {
  const float denormal = std::numeric_limits<float>::denorm_min();
  const std::vector<float> pixels = {
      std::nanf(""), -std::nanf(""), kInfinity, -kInfinity, 0.0F,   -0.0F, -1.0F,
      -1e30F,        1e30F,          denormal,  -denormal,  1e-40F, 1.5F,  std::numeric_limits<float>::max(),
      1e-30F,        1e-7F};
  const DepthView view = viewOf(pixels.data(), static_cast<int>(pixels.size()), 1);
  const std::vector<float> depth = rowOf(view, 0);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(depth[i], pixels[i] == 1.5F ? 1.5F : 0.0F) << "pixel " << i << ", " << pixels[i];
    EXPECT_FALSE(std::signbit(depth[i])) << "pixel " << i;
  }
}

TEST(DepthView, StaysFiniteWhateverTheScaleAndRange) {
  const std::vector<float> pixels = {std::nanf(""), kInfinity, -kInfinity, -2.0F, 0.0F, 1e-45F, 2.0F, 1e30F};
  for (const float scale : {1.0F, -1.0F, 0.0F, 1e30F, 1e-30F, kInfinity, std::nanf("")}) {
    for (const float bound : {-1.0F, 0.0F, 1.0F, kInfinity, -kInfinity, std::nanf("")}) {
      const DepthView view = viewOf(pixels.data(), static_cast<int>(pixels.size()), 1, scale);
      for (const DepthRange& range :
           {DepthRange{bound, 1e3F}, DepthRange{0.0F, bound}, DepthRange{bound, bound}}) {
        for (const float z : rowOf(view, 0, range)) {
          EXPECT_TRUE(std::isfinite(z) && z >= 0.0F && !std::signbit(z))
              << z << " of scale " << scale << ", bound " << bound;
        }
      }
    }
  }
}

TEST(DepthView, BothEndsOfTheRangeAreMissing) {
  const std::vector<std::uint16_t> pixels = {999, 1000, 1001, 1999, 2000, 2001};
  const DepthView view = viewOf(pixels.data(), 6, 1);
  const DepthRange range{1000 * 0.001F, 2000 * 0.001F};
  EXPECT_EQ(rowOf(view, 0, range), (std::vector<float>{0, 0, 1001 * 0.001F, 1999 * 0.001F, 0, 0}));
  EXPECT_EQ(columnOf(view, 1, range), std::vector<float>{0});
}

TEST(DepthView, UnitsAreScaled) {
  const std::uint16_t pixel = 5000;
  EXPECT_FLOAT_EQ(rowOf(viewOf(&pixel, 1, 1, 1.0F / 5000.0F), 0)[0], 1.0F);
  const float millimetres = 1500.0F;
  EXPECT_FLOAT_EQ(rowOf(viewOf(&millimetres, 1, 1, 0.001F), 0)[0], 1.5F);
}

TEST(DepthView, PackedViewsDescribeTheirPixels) {
  const std::vector<std::uint16_t> shorts(12, 1);
  const DepthView of_shorts = viewOf(shorts.data(), 4, 3);
  EXPECT_EQ(of_shorts.data, reinterpret_cast<const std::uint8_t*>(shorts.data()));
  EXPECT_EQ(of_shorts.width, 4);
  EXPECT_EQ(of_shorts.height, 3);
  EXPECT_EQ(of_shorts.step, 8U);
  EXPECT_EQ(of_shorts.type, DepthType::kUint16);
  EXPECT_EQ(of_shorts.depth_unit, 0.001F);
  const std::vector<float> floats(12, 1.0F);
  const DepthView of_floats = viewOf(floats.data(), 4, 3);
  EXPECT_EQ(of_floats.step, 16U);
  EXPECT_EQ(of_floats.type, DepthType::kFloat32);
  EXPECT_EQ(of_floats.depth_unit, 1.0F);
}

TEST(DepthView, HasAnOlderNameForItsUnit) {
  const std::uint16_t pixel = 3;
  DepthView view = viewOf(&pixel, 1, 1);
  EXPECT_EQ(view.metres_per_unit, 0.001F);
  view.metres_per_unit = 0.5F;
  EXPECT_EQ(view.depth_unit, 0.5F);
  float depth = 0.0F;
  EXPECT_EQ(loadRow(view, 0, DepthRange{}, &depth), 1);
  EXPECT_EQ(depth, 1.5F);
}

TEST(DepthView, EmptyViews) {
  const std::uint16_t pixel = 1000;
  EXPECT_TRUE(DepthView{}.empty());
  EXPECT_TRUE(viewOf(static_cast<const std::uint16_t*>(nullptr), 4, 4).empty());
  EXPECT_TRUE(viewOf(&pixel, 0, 1).empty());
  EXPECT_TRUE(viewOf(&pixel, 1, 0).empty());
  EXPECT_TRUE(viewOf(&pixel, -1, 1).empty());
  EXPECT_TRUE(viewOf(&pixel, 1, -1).empty());
  EXPECT_FALSE(viewOf(&pixel, 1, 1).empty());
  float untouched = -1.0F;
  loadRow(viewOf(&pixel, 0, 1), 0, kWide, &untouched);
  EXPECT_EQ(untouched, -1.0F);
}

TEST(LoadRow, ReadsDepthBelowAMicrometreAsInvalid) {
  const std::vector<float> pixels = {0.7e-6F, 1.5e-6F};
  std::vector<float> depth(2);
  EXPECT_EQ(loadRow(viewOf(pixels.data(), 2, 1), 0, kWide, depth.data()), 1);
  EXPECT_EQ(depth, (std::vector<float>{0.0F, 1.5e-6F}));
}

}  // namespace
}  // namespace line_plane_segmentation
