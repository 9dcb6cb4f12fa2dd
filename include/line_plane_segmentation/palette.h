// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// Colour of 8 bits per channel.
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
};

/// Number of different colours of colorOf().
constexpr std::uint32_t kPaletteSize = 60;

/// Returns the colour of the plane with this id, from 1, for all outputs: 20 easily distinguished colours,
/// then 20 darker and 20 lighter ones, repeated after kPaletteSize.
inline Color colorOf(std::uint32_t id) {
  constexpr std::size_t kColorCount = 20;
  constexpr std::array<Color, kColorCount> kColors = {{
      {231, 76, 60},   {46, 204, 113}, {52, 152, 219},  {241, 196, 15}, {155, 89, 182},
      {230, 126, 34},  {40, 190, 176}, {255, 105, 180}, {107, 142, 35}, {60, 60, 160},
      {210, 220, 120}, {160, 60, 90},  {135, 206, 235}, {255, 127, 80}, {20, 140, 90},
      {200, 140, 200}, {140, 90, 40},  {130, 230, 170}, {65, 105, 225}, {240, 130, 130},
  }};
  constexpr std::size_t kShadeCount = 3;
  const std::size_t index = (id + kColorCount * kShadeCount - 1) % (kColorCount * kShadeCount);
  Color color = kColors[index % kColorCount];
  const std::size_t shade = index / kColorCount;
  for (std::uint8_t* channel : {&color.r, &color.g, &color.b}) {
    if (shade == 1) *channel = static_cast<std::uint8_t>(*channel / 2);
    if (shade == 2) *channel = static_cast<std::uint8_t>((*channel + 255) / 2);
  }
  return color;
}

}  // namespace line_plane_segmentation
