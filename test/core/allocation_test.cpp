// SPDX-License-Identifier: BSD-3-Clause
// Nothing is allocated in a warm frame, and never much: every call of malloc and its like in this program is
// counted, whoever makes it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/allocation_counter.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

TEST(AllocationCounter, CountsEachWayToAllocate) {
  EXPECT_EQ(allocationsOf([] {}), 0);
  std::unique_ptr<int> by_new;
  EXPECT_EQ(allocationsOf([&] { by_new = std::make_unique<int>(3); }), 1);
  std::vector<int> vector;
  EXPECT_EQ(allocationsOf([&] { vector.resize(1000); }), 1);
  void* volatile memory = nullptr;  // or the compiler leaves out what nobody reads
  EXPECT_EQ(allocationsOf([&] { memory = std::malloc(100); }), 1);
  EXPECT_EQ(allocationsOf([&] { memory = std::realloc(memory, 100000); }), 1);
  std::free(memory);
  EXPECT_EQ(allocationsOf([&] { memory = std::calloc(10, 10); }), 1);
  std::free(memory);
  EXPECT_EQ(allocationsOf([&] { memory = std::aligned_alloc(64, 640); }), 1);
  std::free(memory);
}

TEST(AllocationCounter, KnowsThePeak) {
  // Small enough for none to be rounded up to whole pages.
  const auto kilobytes_of = [](const auto& function) { return (peakOf(function) + 500) / 1024; };
  std::vector<char> first, second;
  EXPECT_EQ(peakOf([] {}), 0);
  EXPECT_EQ(kilobytes_of([&] { first.resize(70 << 10); }), 70);
  EXPECT_EQ(kilobytes_of([&] {
              first = std::vector<char>();
              second.resize(50 << 10);
              first.resize(40 << 10);
              second = std::vector<char>();
            }),
            20);
  EXPECT_EQ(kilobytes_of([&] { first.reserve(60 << 10); }), 60) << "both exist while it moves";
}

/// A sequence of frames, as a moving camera has it: each is another image, and some have more in them than
/// others.
std::vector<std::vector<std::uint16_t>> frames(int width, int height) {
  std::vector<std::vector<std::uint16_t>> all;
  for (const std::uint64_t seed : {15U, 18U, 20U, 22U, 25U})
    all.push_back(toMillimetres(randomScene(seed, width, height)));
  return all;
}

/// White noise of so many millimetres about 1.5 m.
std::vector<std::uint16_t> noise(int millimetres, int width, int height) {
  Random random(7);
  std::vector<std::uint16_t> pixels(static_cast<std::size_t>(width * height));
  for (std::uint16_t& pixel : pixels)
    pixel = static_cast<std::uint16_t>(1500.0 + random.uniform(-millimetres, millimetres));
  return pixels;
}

/// Squares of so many pixels, near and far.
std::vector<std::uint16_t> checkerboard(int side, int width, int height) {
  std::vector<std::uint16_t> pixels;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) pixels.push_back((u / side + v / side) % 2 == 0 ? 1000 : 1500);
  }
  return pixels;
}

class WarmFrame : public testing::TestWithParam<Method> {};

TEST_P(WarmFrame, AllocatesNothing) {
  Parameters parameters;
  parameters.method = GetParam();
  PlaneSegmenter segmenter(parameters);
  const std::vector<std::vector<std::uint16_t>> images = frames(640, 480);
  const auto segment_all = [&] {
    std::size_t planes = 0;
    for (const std::vector<std::uint16_t>& pixels : images) {
      planes += segmenter.segment(viewOf(pixels.data(), 640, 480), kinectCamera(640, 480)).planes.size();
    }
    return planes;
  };
  EXPECT_GT(allocationsOf(segment_all), 0) << "the first frames have to";
  EXPECT_GT(segment_all(), 10U) << "the images are too poor to test anything";
  EXPECT_EQ(allocationsOf(segment_all), 0);
}

TEST_P(WarmFrame, AllocatesNothingForASmallerImage) {
  Parameters parameters;
  parameters.method = GetParam();
  PlaneSegmenter segmenter(parameters);
  const std::vector<std::uint16_t> large = frames(640, 480)[1], small = frames(320, 240)[1];
  const auto segment_both = [&] {
    segmenter.segment(viewOf(large.data(), 640, 480), kinectCamera(640, 480));
    segmenter.segment(viewOf(small.data(), 320, 240), kinectCamera(320, 240));
  };
  segment_both();
  EXPECT_EQ(allocationsOf(segment_both), 0);
}

// Of all that a segmenter ever allocates, also while something grows, with images that need much of one thing
// or the other: planes, surfaces, borders.
TEST_P(WarmFrame, NeedsLittleMemory) {
  const long most = GetParam() == Method::kAdaptive ? 8 << 20 : 10 << 20;
  std::vector<std::vector<std::uint16_t>> images = frames(640, 480);
  images.push_back(toMillimetres(blankDepth(640, 480)));
  images.push_back(toMillimetres(render(surfaceAt(1.5, 0.3, 0.2), kinectCamera(640, 480), 640, 480)));
  for (const int step : {1, 20, 300}) images.push_back(noise(step, 640, 480));
  images.push_back(checkerboard(8, 640, 480));

  Parameters parameters;
  parameters.method = GetParam();
  std::unique_ptr<PlaneSegmenter> segmenter;
  const long peak = peakOf([&] {
    segmenter = std::make_unique<PlaneSegmenter>(parameters);
    for (const std::vector<std::uint16_t>& pixels : images)
      segmenter->segment(viewOf(pixels.data(), 640, 480), kinectCamera(640, 480));
  });
  RecordProperty("peak_kilobytes", static_cast<int>(peak / 1000));
  EXPECT_GT(peak, 640 * 480 * 2) << "not even its labels have been counted";
  EXPECT_LT(peak, most);
}

// Each image has other planes than the one before, none of which is ever forgotten for its age.
TEST(WarmTracker, AllocatesNothingHoweverMuchItHasSeen) {
  TrackingParameters parameters;
  parameters.track_memory = 1e9;
  PlaneTracker tracker(parameters);
  PlaneSegmenter segmenter;
  std::vector<Segmentation> segmentations;
  for (const std::vector<std::uint16_t>& pixels : frames(640, 480)) {
    segmentations.push_back(segmenter.segment(viewOf(pixels.data(), 640, 480), kinectCamera(640, 480)));
  }
  const Eigen::Isometry3d motion(Eigen::Translation3d(0.0, 0.0, 0.5));
  double seconds = 0.0;
  std::uint32_t newest = 0;
  const auto track_all = [&] {
    for (const Segmentation& segmentation : segmentations) {
      for (const std::uint32_t id : tracker.track(segmentation, kinectCamera(640, 480), ++seconds, &motion))
        newest = std::max(newest, id);
    }
  };
  EXPECT_GT(allocationsOf(track_all), 0);
  for (int round = 0; round < 100; ++round) track_all();
  const std::uint32_t before = newest;
  EXPECT_EQ(allocationsOf([&] {
              for (int round = 0; round < 100; ++round) track_all();
            }),
            0);
  EXPECT_GT(newest, before + 500) << "too few new planes to fill its memory";
}

// Facets of 5 pixels: 49,152 planes at 1280x960. A matrix of all tracks and all planes would take 19 GB.
TEST(WarmTracker, NeedsLittleMemoryForMorePlanesThanItTracks) {
  constexpr int kWidth = 1280, kHeight = 960, kSide = 5;
  Segmentation facets;
  facets.width = kWidth;
  facets.height = kHeight;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u)
      facets.labels.push_back(static_cast<std::uint16_t>(v / kSide * (kWidth / kSide) + u / kSide + 1));
  }
  for (int k = 0; k < kWidth / kSide * (kHeight / kSide); ++k) {
    SegmentedPlane plane;
    plane.label = static_cast<std::uint16_t>(k + 1);
    plane.normal = Eigen::Vector3d(0.1 * std::sin(k), 0.1 * std::cos(k), -1.0).normalized();
    plane.centroid = {0.01 * (k % 256), 0.01 * (k / 256), 2.0};
    plane.d = -plane.normal.dot(plane.centroid);
    plane.area = 1e-4;
    facets.planes.push_back(plane);
  }
  PlaneTracker tracker;
  std::vector<std::uint32_t> ids[2];
  const long peak = peakOf([&] {
    for (int image = 0; image < 4; ++image)
      ids[image % 2] = tracker.track(facets, kinectCamera(kWidth, kHeight), image / 30.0);
  });
  EXPECT_LT(peak, 4 << 20);
  EXPECT_EQ(facets.planes.size() - kMaxTrackedPlanes, tracker.untracked());
  EXPECT_EQ(ids[0], ids[1]);
  EXPECT_EQ(kFirstUntrackedId + facets.planes.size(), ids[0].back());
  std::sort(ids[0].begin(), ids[0].end());
  EXPECT_EQ(ids[0].end(), std::adjacent_find(ids[0].begin(), ids[0].end())) << "an id twice in one image";
}

INSTANTIATE_TEST_SUITE_P(Methods, WarmFrame, testing::Values(Method::kPaper, Method::kAdaptive),
                         [](const auto& method) {
                           return method.param == Method::kPaper ? "Paper" : "Adaptive";
                         });

}  // namespace
}  // namespace line_plane_segmentation
