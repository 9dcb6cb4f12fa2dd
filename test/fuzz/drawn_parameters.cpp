// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_parameters.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace line_plane_segmentation {
namespace {

// Small values more often: there is more to be seen between 1 and 10 than between 900 and 1000.
template <typename T>
T drawWithin(ByteReader& bytes, T min, T max) {
  const double share = bytes.uniform(0.0, 1.0);
  const double low = static_cast<double>(min);
  const double high = static_cast<double>(max);
  return static_cast<T>(low + (high - low) * share * share * share * share);
}
template <>
bool drawWithin(ByteReader& bytes, bool, bool) {
  return bytes.chance(128);
}
template <>
Method drawWithin(ByteReader& bytes, Method, Method) {
  return bytes.chance(128) ? Method::kPaper : Method::kAdaptive;
}

// Sets the parameter of this number, if there are so many.
struct ParameterDrawer {
  template <typename T, typename Bound>
  void operator()(const char*, T& value, Bound min, Bound max) {
    if (index-- == 0) value = drawWithin(bytes, static_cast<T>(min), static_cast<T>(max));
  }
  int index;
  ByteReader& bytes;
};

}  // namespace

Parameters drawParameters(ByteReader& bytes) {
  constexpr const char* kPresets[] = {"kinect", "short_range", "paper"};
  Parameters parameters;
  EXPECT_TRUE(loadPreset(kPresets[bytes.integer(0, 2)], parameters));
  EXPECT_TRUE(sanitize(parameters).empty()) << "a preset is in order";
  for (int i = bytes.integer(0, 7); i > 0; --i) {
    ParameterDrawer drawer{bytes.integer(0, 33), bytes};
    visitParameters(parameters, drawer);
  }
  sanitize(parameters);
  return parameters;
}

LocationParameters drawLocationParameters(ByteReader& bytes) {
  LocationParameters parameters;
  for (int i = bytes.integer(0, 3); i > 0; --i) {
    ParameterDrawer drawer{bytes.integer(0, 9), bytes};
    visitTrackingParameters(parameters.tracking, drawer);
    visitOrientationParameters(parameters.orientation, drawer);
  }
  const int frames = bytes.integer(0, 7);
  if ((frames & 1) != 0) parameters.frames.target_frame = "target";
  if ((frames & 2) != 0) parameters.frames.gravity_frame = "gravity";
  if ((frames & 4) != 0) parameters.frames.fixed_frame = "fixed";
  return parameters;
}

}  // namespace line_plane_segmentation
