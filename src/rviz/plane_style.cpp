// SPDX-License-Identifier: BSD-3-Clause
#include "plane_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "line_plane_segmentation/orientation.h"

namespace line_plane_segmentation {
namespace {

constexpr std::array<Color, kOrientationCount> kOfOrientation = {{
    {150, 150, 150},  // unknown
    {46, 204, 113},   // horizontal_up
    {241, 196, 15},   // horizontal_down
    {52, 152, 219},   // vertical
    {231, 76, 60},    // slanted
}};

// The area as a hue from blue to red, on a logarithmic scale.
Color colorOfArea(float area) {
  const float position = std::clamp((std::log10(std::max(area, 1e-6F)) + 1.0F) / 2.0F, 0.0F, 1.0F);
  const auto channel = [](float value) {
    return static_cast<std::uint8_t>(255.0F * std::clamp(value, 0.0F, 1.0F));
  };
  return {channel(2.0F * position - 0.5F), channel(1.5F - std::abs(4.0F * position - 2.0F)),
          channel(1.5F - 2.0F * position)};
}

}  // namespace

Color colorOf(const Plane& plane, ColorBy color_by) {
  switch (color_by) {
    case ColorBy::kOrientation:
      return kOfOrientation[std::min<std::size_t>(plane.orientation, kOfOrientation.size() - 1)];
    case ColorBy::kArea:
      return colorOfArea(plane.area);
    case ColorBy::kId:
      break;
  }
  return colorOf(plane.id);
}

}  // namespace line_plane_segmentation
