// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <ctime>
#include <new>

#include "core/outline_checks.h"
#include "core/outline_images.h"
#include "outline/outline.h"
#include "support/random.h"

namespace {

std::atomic<long> allocations{0};

void* allocate(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Every allocation of this program is counted.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace line_plane_segmentation {
namespace {

TEST(OutlineCostTest, NothingIsAllocatedWhenWarm) {
  OutlineTracer tracer;
  OutlineParameters parameters;
  parameters.min_hole_pixels = 5;
  for (const OutlinePicture picture : kAllOutlinePictures) {
    Segmentation segmentation = outlinePicture(picture, 160, 120, 3);
    const CameraIntrinsics camera = outlineCamera(160, 120);
    const long before = allocations;
    tracer.trace(camera, parameters, segmentation);
    const long cold = allocations;
    tracer.trace(camera, parameters, segmentation);
    EXPECT_EQ(allocations, cold) << nameOf(picture);
    EXPECT_GT(cold, before) << nameOf(picture) << ": the counter does not count";
  }
}

TEST(OutlineCostTest, LongWindingBordersTakeNoQuadraticTime) {
  // Up to a million corners, some in one border: less than half a second of processor time each, where
  // quadratic time would be many minutes.
  constexpr double kSeconds = 20.0;
  OutlineTracer tracer;
  OutlineParameters parameters;
  for (const OutlinePicture picture : kAllOutlinePictures) {
    Segmentation segmentation = outlinePicture(picture, 1200, 1000, 1);
    const std::clock_t start = std::clock();
    tracer.trace(outlineCamera(1200, 1000), parameters, segmentation);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kSeconds) << nameOf(picture);
    EXPECT_EQ(faultOf(segmentation), "") << nameOf(picture);
    EXPECT_FALSE(segmentation.rings.empty()) << nameOf(picture);
  }
}

TEST(OutlineCostTest, WhiteNoiseOfManyLabelsHasNextToNoOutline) {
  Random random(5);
  std::vector<std::uint16_t> labels(1920U * 1080U);
  for (std::uint16_t& label : labels) label = static_cast<std::uint16_t>(random.integer(0, 40));
  Segmentation segmentation = segmentationOf(1920, 1080, std::move(labels));
  OutlineTracer().trace(outlineCamera(1920, 1080), OutlineParameters(), segmentation);
  EXPECT_EQ(faultOf(segmentation), "");
  // Of each label the largest part, a few pixels in size.
  EXPECT_EQ(segmentation.rings.size(), 40U);
  EXPECT_LT(segmentation.vertices.size(), 400U);
}

}  // namespace
}  // namespace line_plane_segmentation
