// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_parameters.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace line_plane_segmentation {
namespace {

// Small values more often: there is more to be seen between 1 and 10 than between 900 and 1000.
template <typename T>
T drawWithin(ByteReader& bytes, T min, T max) {
  const double fraction = bytes.uniform(0.0, 1.0);
  const double low = static_cast<double>(min);
  const double high = static_cast<double>(max);
  return static_cast<T>(low + (high - low) * fraction * fraction * fraction * fraction);
}
template <>
bool drawWithin(ByteReader& bytes, bool, bool) {
  return bytes.chance(128);
}
template <>
Method drawWithin(ByteReader& bytes, Method, Method) {
  return bytes.chance(128) ? Method::kPaper : Method::kAdaptive;
}

template <typename Visit>
void drawOne(ByteReader& bytes, Visit visit) {
  actOnOne(bytes, visit, [&](const char*, auto& value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    value = drawWithin(bytes, static_cast<T>(min), static_cast<T>(max));
  });
}

}  // namespace

Parameters drawParameters(ByteReader& bytes) {
  Parameters parameters;
  EXPECT_TRUE(
      loadPreset(kPresetNames[bytes.integer(0, static_cast<int>(kPresetNames.size()) - 1)], parameters));
  EXPECT_TRUE(sanitize(parameters).empty()) << "a preset is in order";
  for (int i = bytes.integer(0, 7); i > 0; --i) {
    drawOne(bytes, [&](auto visitor) { visitParameters(parameters, visitor); });
  }
  sanitize(parameters);
  return parameters;
}

LocationParameters drawLocationParameters(ByteReader& bytes) {
  LocationParameters parameters;
  for (int i = bytes.integer(0, 3); i > 0; --i) {
    drawOne(bytes, [&](auto visitor) {
      visitTrackingParameters(parameters.tracking, visitor);
      visitOrientationParameters(parameters.orientation, visitor);
    });
  }
  const int frames = bytes.integer(0, 7);
  if ((frames & 1) != 0) parameters.frames.target_frame = "target";
  if ((frames & 2) != 0) parameters.frames.gravity_frame = "gravity";
  if ((frames & 4) != 0) parameters.frames.fixed_frame = "fixed";
  return parameters;
}

}  // namespace line_plane_segmentation
