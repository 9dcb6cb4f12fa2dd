// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_segmenter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/random.h"
#include "support/segmentation_checks.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// A corner of a room: a floor and two walls, with the noise of a Kinect in whole millimetres.
const Surface kCorner[] = {surfaceAt(2.2, 0.0, -1.0), surfaceAt(2.0, 0.75), surfaceAt(2.0, -0.75)};

DepthImage roomCorner(int width, int height, double noise_factor) {
  const CameraIntrinsics camera = kinectCamera(width, height);
  DepthImage depth = blankDepth(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      double nearest = 20.0;
      for (const Surface& surface : kCorner) {
        const double z = surface.depthAlong((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
        if (z > 0.0) nearest = std::min(nearest, z);
      }
      depth.row(v)[u] = static_cast<float>(nearest);
    }
  }
  Random random(5);
  addNoise({}, noise_factor, random, depth);
  return depth;
}

std::vector<float> toMetres(const std::vector<std::uint16_t>& millimetres) {
  std::vector<float> metres(millimetres.size());
  std::transform(millimetres.begin(), millimetres.end(), metres.begin(),
                 [](std::uint16_t mm) { return static_cast<float>(mm) * 0.001F; });
  return metres;
}

class PlaneSegmenterTest : public testing::TestWithParam<Method> {
 protected:
  Parameters parameters() const {
    Parameters p;
    p.method = GetParam();
    return p;
  }

  /// Segments a view and checks the result against the depths that the segmenter has to see in it.
  const Segmentation& segment(const DepthView& view, PlaneSegmenter& segmenter) const {
    const Segmentation& result = segmenter.segment(view, kinectCamera(view.width, view.height));
    const ScanlineParameters& range = segmenter.parameters().scanlines;
    DepthImage depth;
    loadDepth(view, {static_cast<float>(range.min_range), static_cast<float>(range.max_range)}, depth);
    expectConsistent(result, depth);
    return result;
  }
};

TEST_P(PlaneSegmenterTest, FindsTheCornerOfARoom) {
  PlaneSegmenter segmenter(parameters());
  for (const int width : {320, 640}) {
    const std::vector<std::uint16_t> pixels = toMillimetres(roomCorner(width, width * 3 / 4, 0.5));
    const Segmentation& result = segment(viewOf(pixels.data(), width, width * 3 / 4), segmenter);
    for (const Surface& surface : kCorner) {
      const auto is_it = [&](const SegmentedPlane& plane) {
        return plane.normal.dot(surface.normal) > std::cos(0.035) && std::abs(plane.d - surface.d) < 0.03;
      };
      EXPECT_EQ(std::count_if(result.planes.begin(), result.planes.end(), is_it), 1)
          << width << ", " << surface.normal.transpose();
    }
    EXPECT_GT(result.assigned_pixels, 0.8 * width * width * 3 / 4);
    EXPECT_FALSE(segmenter.lineSegments().empty());
    EXPECT_FALSE(segmenter.candidates().empty());
  }
}

// At 4.5 m a Kinect's noise is wider than the paper's distances, which cut the wall to pieces.
TEST(Tolerances, FollowTheSensorsNoise) {
  DepthImage depth = render(surfaceAt(4.5), kinectCamera(640, 480), 640, 480);
  Random random(5);
  addNoise(NoiseParameters{}, 1.0, random, depth);
  const std::vector<std::uint16_t> pixels = toMillimetres(depth);
  const auto largest_share = [&pixels](const char* preset) {
    Parameters parameters;
    EXPECT_TRUE(loadPreset(preset, parameters));
    PlaneSegmenter segmenter(parameters);
    const auto& planes = segmenter.segment(viewOf(pixels.data(), 640, 480), kinectCamera(640, 480)).planes;
    return planes.empty() ? 0.0 : planes.front().inliers / (640.0 * 480.0);
  };
  EXPECT_GT(largest_share("kinect"), 0.99);
  EXPECT_LT(largest_share("paper"), 0.5);
}

TEST_P(PlaneSegmenterTest, OfAnEmptyViewIsEmpty) {
  PlaneSegmenter segmenter(parameters());
  EXPECT_TRUE(segmenter.lineSegments().empty());
  EXPECT_TRUE(segmenter.candidates().empty());
  const std::vector<std::uint16_t> pixels = toMillimetres(roomCorner(64, 48, 0.5));
  DepthView no_data = viewOf(pixels.data(), 64, 48);
  segment(no_data, segmenter);  // leaves something behind that must go
  no_data.data = nullptr;
  for (const DepthView& view : {no_data, viewOf(pixels.data(), 0, 48), viewOf(pixels.data(), 64, 0),
                                viewOf(pixels.data(), -64, 48), DepthView{}}) {
    const Segmentation& result = segmenter.segment(view, kinectCamera(64, 48));
    EXPECT_TRUE(result.planes.empty());
    EXPECT_TRUE(result.rings.empty());
    EXPECT_TRUE(result.vertices.empty());
    EXPECT_EQ(result.labels.size(),
              static_cast<std::size_t>(std::max(0, view.width) * std::max(0, view.height)));
    EXPECT_EQ(std::count(result.labels.begin(), result.labels.end(), 0),
              static_cast<std::ptrdiff_t>(result.labels.size()));
    EXPECT_EQ(result.valid_pixels, 0U);
    EXPECT_EQ(result.assigned_pixels, 0U);
    EXPECT_TRUE(segmenter.lineSegments().empty());
    EXPECT_TRUE(segmenter.candidates().empty());
  }
}

TEST_P(PlaneSegmenterTest, OfAnInvalidCameraIsEmpty) {
  PlaneSegmenter segmenter(parameters());
  const std::vector<std::uint16_t> pixels = toMillimetres(roomCorner(320, 240, 0.5));
  segment(viewOf(pixels.data(), 320, 240), segmenter);
  const double nan = std::nan("");
  for (const CameraIntrinsics& camera :
       {CameraIntrinsics{}, CameraIntrinsics{-262, 262, 160, 120}, CameraIntrinsics{262, nan, 160, 120}}) {
    const Segmentation& result = segmenter.segment(viewOf(pixels.data(), 320, 240), camera);
    EXPECT_TRUE(result.planes.empty());
    EXPECT_EQ(std::count(result.labels.begin(), result.labels.end(), 0), 320 * 240);
    EXPECT_EQ(result.assigned_pixels, 0U);
  }
}

TEST_P(PlaneSegmenterTest, OfNoDepthIsEmpty) {
  PlaneSegmenter segmenter(parameters());
  const std::vector<std::uint16_t> zeros(320 * 240, 0), far(320 * 240, 60000);
  const std::vector<float> nans(320 * 240, std::nanf(""));
  for (const DepthView& view :
       {viewOf(zeros.data(), 320, 240), viewOf(far.data(), 320, 240), viewOf(nans.data(), 320, 240)}) {
    EXPECT_TRUE(segment(view, segmenter).planes.empty());
  }
}

TEST_P(PlaneSegmenterTest, TakesEverySize) {
  const std::pair<int, int> sizes[] = {{1, 1},   {1, 2},    {2, 1},    {2, 2},    {3, 3},   {1, 300},
                                       {300, 1}, {2, 300},  {300, 2},  {5, 7},    {15, 15}, {16, 16},
                                       {17, 33}, {40, 200}, {200, 40}, {641, 479}};
  PlaneSegmenter segmenter(parameters());
  for (const auto& size : sizes) {
    SCOPED_TRACE(std::to_string(size.first) + " x " + std::to_string(size.second));
    for (const double noise_factor : {0.0, 1.0}) {
      const std::vector<std::uint16_t> pixels =
          toMillimetres(roomCorner(size.first, size.second, noise_factor));
      segment(viewOf(pixels.data(), size.first, size.second), segmenter);
    }
  }
}

TEST_P(PlaneSegmenterTest, SeesOnePlaneInConstantDepth) {
  PlaneSegmenter segmenter(parameters());
  const std::vector<std::uint16_t> pixels(320 * 240, 1500);
  const Segmentation& result = segment(viewOf(pixels.data(), 320, 240), segmenter);
  ASSERT_EQ(result.planes.size(), 1U);
  EXPECT_EQ(result.planes[0].inliers, 320U * 240U);
  EXPECT_NEAR(result.planes[0].d, 1.5, 1e-6);
}

TEST_P(PlaneSegmenterTest, SeesNoPlanesInWhiteNoiseOrACheckerboard) {
  PlaneSegmenter segmenter(parameters());
  Random random(6);
  std::vector<std::uint16_t> noise(320 * 240), board(320 * 240);
  for (std::uint16_t& pixel : noise) pixel = static_cast<std::uint16_t>(random.integer(0, 8000));
  for (std::size_t i = 0; i < board.size(); ++i) board[i] = (i % 320 + i / 320) % 2 == 0 ? 1000 : 2000;
  EXPECT_TRUE(segment(viewOf(noise.data(), 320, 240), segmenter).planes.empty());
  EXPECT_TRUE(segment(viewOf(board.data(), 320, 240), segmenter).planes.empty());
}

TEST_P(PlaneSegmenterTest, GivesTheSameBitsAgainAndAfterOtherImages) {
  const std::vector<std::uint16_t> room = toMillimetres(roomCorner(320, 240, 1.0));
  const DepthView view = viewOf(room.data(), 320, 240);
  PlaneSegmenter segmenter(parameters());
  const Segmentation first = segment(view, segmenter);
  ASSERT_GE(first.planes.size(), 2U);
  expectSameBits(segment(view, segmenter), first);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const int width = random.integer(1, 400), height = random.integer(1, 300);
    const std::vector<std::uint16_t> other = toMillimetres(randomScene(seed, width, height));
    segment(viewOf(other.data(), width, height), segmenter);
    expectSameBits(segment(view, segmenter), first);
    segmenter.segment({}, {});
  }
  PlaneSegmenter fresh(parameters());
  expectSameBits(segment(view, fresh), first);
}

TEST_P(PlaneSegmenterTest, GivesTheSameForEveryWayToStoreAnImage) {
  const std::vector<std::uint16_t> pixels = toMillimetres(roomCorner(320, 240, 1.0));
  const std::vector<float> metres = toMetres(pixels);
  PlaneSegmenter segmenter(parameters());
  const Segmentation expected = segment(viewOf(pixels.data(), 320, 240), segmenter);
  ASSERT_GE(expected.planes.size(), 2U);
  expectSameBits(segment(viewOf(metres.data(), 320, 240), segmenter), expected);

  DepthView padded = viewOf(pixels.data(), 320, 240);
  padded.step += 6;
  std::vector<std::uint8_t> bytes(1 + padded.step * 240, 0xEE);
  for (std::size_t v = 0; v < 240; ++v) {
    const std::uint8_t* row = reinterpret_cast<const std::uint8_t*>(pixels.data() + 320 * v);
    std::copy(row, row + 640, bytes.begin() + static_cast<std::ptrdiff_t>(1 + padded.step * v));
  }
  padded.data = bytes.data() + 1;  // an odd address, too
  expectSameBits(segment(padded, segmenter), expected);
}

TEST_P(PlaneSegmenterTest, TakesEveryParameterAtItsBounds) {
  const std::vector<std::uint16_t> pixels = toMillimetres(roomCorner(96, 72, 1.0));
  const Parameters defaults;
  visitParameters(defaults, [&](const char* name, const auto&, auto, auto) {
    if (std::string(name) == "method") return;
    for (const bool at_max : {false, true}) {
      Parameters p = parameters();
      visitParameters(p, [&](const char* known, auto& field, auto min, auto max) {
        if (std::string(known) == name)
          field = static_cast<std::decay_t<decltype(field)>>(at_max ? max : min);
      });
      SCOPED_TRACE(std::string(name) + (at_max ? " at its maximum" : " at its minimum"));
      PlaneSegmenter segmenter(p);
      segment(viewOf(pixels.data(), 96, 72), segmenter);
      for (const LineSegment& line : segmenter.lineSegments())
        EXPECT_TRUE(std::isfinite(line.alpha) && std::isfinite(line.r));
      for (const PlaneCandidate& candidate : segmenter.candidates())
        EXPECT_TRUE(candidate.normal.allFinite());
    }
  });
}

TEST_P(PlaneSegmenterTest, SanitizesParametersAndTakesThemWithTheNextFrame) {
  const std::vector<std::uint16_t> pixels(320 * 240, 1500);
  PlaneSegmenter segmenter(parameters());
  EXPECT_EQ(segment(viewOf(pixels.data(), 320, 240), segmenter).planes.size(), 1U);
  Parameters p = parameters();
  p.scanlines.max_range = 1.0;
  p.extraction.plane_distance = std::nan("");
  segmenter.setParameters(p);
  EXPECT_EQ(segmenter.parameters().scanlines.max_range, 1.0);
  EXPECT_EQ(segmenter.parameters().extraction.plane_distance, Parameters{}.extraction.plane_distance);
  EXPECT_TRUE(segment(viewOf(pixels.data(), 320, 240), segmenter).planes.empty());
  segmenter.setParameters(parameters());
  EXPECT_EQ(segment(viewOf(pixels.data(), 320, 240), segmenter).planes.size(), 1U);
}

TEST_P(PlaneSegmenterTest, WorksOnWhenMoved) {
  const std::vector<std::uint16_t> pixels(320 * 240, 1500);
  PlaneSegmenter first(parameters());
  segment(viewOf(pixels.data(), 320, 240), first);
  PlaneSegmenter second(std::move(first));
  EXPECT_EQ(segment(viewOf(pixels.data(), 320, 240), second).planes.size(), 1U);
  first = PlaneSegmenter(parameters());
  EXPECT_EQ(segment(viewOf(pixels.data(), 320, 240), first).planes.size(), 1U);
}

TEST(KinectWidth, FollowsTheAngleThatAPixelSees) {
  EXPECT_EQ(kinectWidthOf({525.0, 525.0, 319.5, 239.5}, 640, 480), 640);
  EXPECT_EQ(kinectWidthOf({525.0, 525.0, 239.5, 319.5}, 480, 640), 640) << "turned";
  EXPECT_EQ(kinectWidthOf({262.5, 262.5, 159.5, 119.5}, 320, 240), 320);
  EXPECT_EQ(kinectWidthOf({5250.0, 5250.0, 319.5, 239.5}, 640, 480), 960) << "1.2 diagonals";
  EXPECT_EQ(kinectWidthOf({1e-9, 1e-9, 0.0, 0.0}, 1, 1), 1);
}

INSTANTIATE_TEST_SUITE_P(Methods, PlaneSegmenterTest, testing::Values(Method::kPaper, Method::kAdaptive),
                         [](const auto& method) {
                           return method.param == Method::kPaper ? "Paper" : "Adaptive";
                         });

}  // namespace
}  // namespace line_plane_segmentation
