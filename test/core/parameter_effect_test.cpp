// SPDX-License-Identifier: BSD-3-Clause
// Every parameter has an effect on the methods that use it, and none on the others.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

/// What a robot may see: a corner, a column, a near board with a hole, a step, a far end, something rough,
/// and pixels without depth; with a Kinect's noise.
DepthImage scene() {
  DepthImage depth = render(surfaceAt(3.0), kCamera, kWidth, kHeight);
  Random random(11);
  paint(surfaceAt(2.6, 0.7), kCamera, {160, 320, 0, 120}, depth);
  paint(surfaceAt(1.2, 0.0, -0.5), kCamera, {0, 200, 150, 240}, depth);
  paint(surfaceAt(0.8), kCamera, {20, 110, 20, 100}, depth);
  paint(surfaceAt(3.0), kCamera, {50, 75, 45, 70}, depth);
  paint(surfaceAt(1.22), kCamera, {200, 260, 150, 240}, depth);
  paint(surfaceAt(9.5), kCamera, {130, 160, 0, 120}, depth);
  for (int v = 130; v < kHeight; ++v) {
    for (int u = 262; u < kWidth; ++u) {
      const double across = (u - 290.0) / 30.0;
      depth.row(v)[u] =
          static_cast<float>(1.5 + 0.06 * across * across + (v < 180 ? 0.02 * random.uniform(-1, 1) : 0.0));
    }
  }
  addNoise({}, 1.0, random, depth);
  for (int i = 0; i < 400; ++i)
    depth.row(static_cast<int>(random.uniform(0, kHeight)))[static_cast<int>(random.uniform(0, kWidth))] =
        0.0F;
  return depth;
}

/// Everything that a segmentation says, in full precision.
std::string resultOf(const DepthImage& depth, const Parameters& parameters) {
  PlaneSegmenter segmenter(parameters);
  const Segmentation& result = segmenter.segment(viewOf(depth.z.data(), depth.width, depth.height), kCamera);
  std::ostringstream text;
  text.precision(17);
  for (const std::uint16_t label : result.labels) text << label << ' ';
  for (const SegmentedPlane& plane : result.planes) {
    text << plane.normal.transpose() << ' ' << plane.d << ' ' << plane.covariance.trace() << '\n';
  }
  for (const auto& vertex : result.vertices) text << vertex.transpose() << ' ';
  text << result.rings.size();
  for (const PlaneCandidate& candidate : segmenter.candidates()) text << candidate.normal.transpose() << ' ';
  text << segmenter.lineSegments().size();
  return text.str();
}

/// Values that differ much from a parameter's default.
template <typename T>
std::vector<T> otherValues(T value, T min, T max) {
  if constexpr (std::is_same_v<T, bool>) {
    return {!value};
  } else if constexpr (std::is_same_v<T, int>) {
    return {min, std::min(max, 3), std::min(max, 5), std::min(max, 40), std::min(max, 2000), max};
  } else {
    return {
        min, std::min(max, 0.05), std::min(max, 2.0 * value), std::min(max, 8.0 * value), std::min(max, 2.0),
        max};
  }
}

class EachParameter : public testing::TestWithParam<Method> {};

TEST_P(EachParameter, HasAnEffectOnTheMethodsThatUseIt) {
  const DepthImage depth = scene();
  Parameters defaults;
  defaults.method = GetParam();
  // The published bounds on the size of a plane leave nothing of so small an image.
  if (defaults.method == Method::kPaper) defaults.extraction.min_plane_inliers = 800;
  const std::string expected = resultOf(depth, defaults);
  visitParameters(defaults, [&](const char* name, const auto& field, auto min, auto max) {
    using T = std::decay_t<decltype(field)>;
    if constexpr (!std::is_same_v<T, Method>) {
      bool has_effect = false;
      for (const T value : otherValues<T>(field, static_cast<T>(min), static_cast<T>(max))) {
        Parameters changed = defaults;
        visitParameters(changed, [&](const char* other, auto& other_field, auto, auto) {
          if constexpr (std::is_same_v<std::decay_t<decltype(other_field)>, T>) {
            if (std::string(other) == name) other_field = value;
          }
        });
        sanitize(changed);
        has_effect = has_effect || resultOf(depth, changed) != expected;
      }
      EXPECT_EQ(has_effect, noEffect(name, defaults.method).empty()) << name;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Methods, EachParameter, testing::Values(Method::kAdaptive, Method::kPaper),
                         [](const auto& each) {
                           return each.param == Method::kPaper ? "Paper" : "Adaptive";
                         });

}  // namespace
}  // namespace line_plane_segmentation
