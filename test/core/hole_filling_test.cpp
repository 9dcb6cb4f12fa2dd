// SPDX-License-Identifier: BSD-3-Clause
#include "depth/hole_filling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "line_plane_segmentation/plane_segmenter.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const CameraIntrinsics kCamera = kinectCamera(kWidth, kHeight);

/// Invalidates every `period`-th row and column.
DepthImage latticed(DepthImage depth, int period) {
  for (int v = 0; v < depth.height; ++v) {
    for (int u = 0; u < depth.width; ++u) {
      if (u % period == 0 || v % period == 0) depth.row(v)[u] = 0.0F;
    }
  }
  return depth;
}

/// Invalidates this fraction of the pixels at random.
DepthImage speckled(DepthImage depth, double fraction) {
  Random random(4);
  addHoles(fraction, 0, random, depth);
  return depth;
}

/// Invalidates 12 of every 24 rows.
DepthImage banded(DepthImage depth) {
  for (int v = 0; v < depth.height; ++v) {
    if (v % 24 >= 12) std::fill_n(depth.row(v), depth.width, 0.0F);
  }
  return depth;
}

TEST(HoleFiller, ContinuesASurfaceBehindALattice) {
  const DepthImage wall = render(surfaceAt(2.0, 0.4, 0.2), kCamera, kWidth, kHeight);
  DepthImage depth = latticed(wall, 8);
  const DepthImage before = depth;
  HoleFiller filler;
  ASSERT_TRUE(filler.fill(adaptiveParameters(kWidth), depth));
  for (int v = 8; v < kHeight - 8; ++v) {
    for (int u = 8; u < kWidth - 8; ++u) {
      const std::size_t i = depth.index(u, v);
      ASSERT_NEAR(depth.z[i], wall.z[i], 1e-3) << u << ' ' << v;
      ASSERT_EQ(filler.filled()[i] != 0, before.z[i] == 0.0F);
    }
  }
}

TEST(HoleFiller, LeavesADenseImageAndItsShadowsAsTheyAre) {
  DepthImage depth = halves(surfaceAt(1.5), surfaceAt(1.9), kCamera, kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v) std::fill_n(depth.row(v) + 155, 12, 0.0F);
  Random random(2);
  addHoles(0.005, 4, random, depth);
  const DepthImage before = depth;
  EXPECT_FALSE(HoleFiller().fill(adaptiveParameters(kWidth), depth));
  EXPECT_EQ(depth.z, before.z);
}

/// Whether an image with one missing pixel in each `across` by `down` pixels is filled.
bool isFilled(int across, int down) {
  DepthImage depth = render(surfaceAt(1.5), kCamera, kWidth, kHeight);
  for (int v = 0; v < kHeight; v += down) {
    for (int u = 0; u < kWidth; u += across) depth.row(v)[u] = 0.0F;
  }
  return HoleFiller().fill(adaptiveParameters(kWidth), depth);
}

TEST(HoleFiller, FillsAnImageWithAHoleIn32PixelsOfARow) {
  EXPECT_TRUE(isFilled(24, 1));
  EXPECT_FALSE(isFilled(42, 1));
}

TEST(HoleFiller, DetectsALatticeOfAnyPeriod) {
  for (const int period : {2, 3, 5}) EXPECT_TRUE(isFilled(period, period)) << period;
}

TEST(HoleFiller, DoesNotFillAcrossAStep) {
  DepthImage depth = latticed(halves(surfaceAt(1.5), surfaceAt(1.9), kCamera, kWidth, kHeight), 8);
  ASSERT_EQ(depth.at(160, 100), 0.0F) << "the step is in a hole";
  HoleFiller filler;
  ASSERT_TRUE(filler.fill(adaptiveParameters(kWidth), depth));
  EXPECT_EQ(depth.at(160, 100), 0.0F);
}

/// Fills the holes of one row or column, pixel by pixel.
void fillPlainly(const Parameters& parameters, int count, const std::function<float&(int)>& at) {
  const int max_hole = parameters.scanlines.scanline_spacing * 3 / 2;
  int last_valid = -1;
  for (int i = 0; i < count; ++i) {
    if (!(at(i) > 0.0F)) continue;
    const int hole = i - last_valid - 1;
    if (last_valid >= 0 && hole > 0 && hole <= max_hole) {
      const double from = 1.0 / static_cast<double>(at(last_valid)), z = static_cast<double>(at(i));
      const double tolerance =
          2.0 * parameters.extraction.distance_noise_factor * parameters.noise.sigma(z) / (z * z);
      for (int k = 1; k <= hole && std::fabs(1.0 / z - from) < tolerance; ++k)
        at(last_valid + k) = static_cast<float>(1.0 / (from + (1.0 / z - from) * k / (hole + 1)));
    }
    last_valid = i;
  }
}

// Rows before columns; holes at borders stay.
TEST(HoleFiller, FillsWhatAPlainLoopFills) {
  const Parameters parameters = adaptiveParameters(kWidth);
  int perforated = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const int width = random.integer(60, 130), height = random.integer(60, 90);
    DepthImage depth = randomScene(seed, width, height);
    addHoles(random.uniform(0.05, 0.8), 3, random, depth);
    DepthImage expected = depth;
    for (int v = 0; v < height; ++v)
      fillPlainly(parameters, width, [&](int u) -> float& { return expected.row(v)[u]; });
    for (int u = 0; u < width; ++u)
      fillPlainly(parameters, height, [&](int v) -> float& { return expected.row(v)[u]; });
    const DepthImage before = depth;
    HoleFiller filler;
    if (!filler.fill(parameters, depth)) continue;
    ++perforated;
    for (std::size_t i = 0; i < depth.z.size(); ++i) {
      ASSERT_NEAR(depth.z[i], expected.z[i], 1e-5) << seed;
      ASSERT_EQ(filler.filled()[i] != 0, depth.z[i] != before.z[i]) << seed;
    }
    filler.removeFilled(depth);
    ASSERT_EQ(depth.z, before.z) << seed;
  }
  EXPECT_GT(perforated, 20);
}

TEST(HoleFiller, OfNothingIsNotPerforated) {
  DepthImage blank = blankDepth(kWidth, kHeight), empty = blankDepth(0, 0);
  EXPECT_FALSE(HoleFiller().fill(adaptiveParameters(kWidth), blank));
  EXPECT_FALSE(HoleFiller().fill(adaptiveParameters(kWidth), empty));
}

/// [m²] that the outline of a plane encloses, by half of the sum of its vertices' cross products.
double enclosedArea(const Segmentation& result, const SegmentedPlane& plane) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int r = plane.first_ring; r < plane.first_ring + plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = result.rings[r];
    const Eigen::Vector3f* const vertices = result.vertices.data() + ring.first_vertex;
    for (int i = 0; i < ring.vertex_count; ++i) {
      const Eigen::Vector3f& next = vertices[(i + 1) % ring.vertex_count];
      sum += vertices[i].cast<double>().cross(next.cast<double>());
    }
  }
  return 0.5 * sum.norm();
}

// Planes as without the holes, down to a third of the pixels; only measured pixels are labelled and counted.
TEST(PerforatedImages, HaveThePlanesOfTheDenseImage) {
  DepthImage dense = halves(surfaceAt(1.8, 0.5), surfaceAt(1.8, -0.5), kCamera, kWidth, kHeight);
  Random random(7);
  addNoise({}, 0.5, random, dense);
  PlaneSegmenter dense_segmenter;
  const std::vector<std::uint16_t> dense_pixels = toMillimetres(dense);
  const double dense_area =
      dense_segmenter.segment(viewOf(dense_pixels.data(), kWidth, kHeight), kCamera).planes.at(0).area;
  for (const DepthImage& depth :
       {latticed(dense, 8), latticed(dense, 3), banded(dense), speckled(dense, 0.5), speckled(dense, 0.66)}) {
    const std::vector<std::uint16_t> pixels = toMillimetres(depth);
    PlaneSegmenter segmenter;
    const Segmentation& result = segmenter.segment(viewOf(pixels.data(), kWidth, kHeight), kCamera);
    ASSERT_EQ(result.planes.size(), 2U);
    EXPECT_GT(result.assigned_pixels, 0.9 * result.valid_pixels);
    std::uint32_t labelled = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (result.labels[i] == 0) continue;
      ASSERT_GT(pixels[i], 0);
      ++labelled;
    }
    EXPECT_EQ(labelled, result.assigned_pixels);
    for (const SegmentedPlane& plane : result.planes) {
      EXPECT_NEAR(plane.d, surfaceAt(1.8, 0.5).d, 0.02);
      EXPECT_NEAR(plane.area, dense_area, 0.1 * dense_area);
      EXPECT_NEAR(enclosedArea(result, plane), dense_area, 0.1 * dense_area);
    }
  }
}

// The same view by more or fewer pixels, or turned, has the same planes.
TEST(SizesInTheView, FollowTheAngleThatAPixelSees) {
  const Surface wall = surfaceAt(2.0, 0.1), box = surfaceAt(1.6, -0.2);
  const auto planes_of = [&](int width, int height, double focal_length) {
    CameraIntrinsics camera = kinectCamera(width, height);
    camera.fx = camera.fy = focal_length;
    DepthImage depth = render(wall, camera, width, height);
    const auto pixel = [&](double x, double centre) { return static_cast<int>(centre + x * focal_length); };
    paint(box, camera,
          {pixel(-0.06, camera.cx), pixel(0.06, camera.cx), pixel(-0.05, camera.cy), pixel(0.05, camera.cy)},
          depth);
    const std::vector<std::uint16_t> pixels = toMillimetres(depth);
    PlaneSegmenter segmenter;
    return segmenter.segment(viewOf(pixels.data(), width, height), camera).planes.size();
  };
  for (const double focal_length : {262.5, 425.0, 525.0, 1050.0}) {
    const int width = static_cast<int>(640 * focal_length / 525.0), height = width * 3 / 4;
    EXPECT_EQ(planes_of(width, height, focal_length), 2U) << focal_length;
    EXPECT_EQ(planes_of(height, width, focal_length), 2U) << focal_length << ", turned";
  }
  EXPECT_EQ(planes_of(848, 480, 425.0), 2U);
}

// Lengths in pixels grow with the focal length, at most to those of an image that is 1.2 times as wide as
// this one's diagonal.
TEST(SizesInTheView, AreBoundedForALongFocalLength) {
  CameraIntrinsics camera = kinectCamera(640, 480);
  camera.fx = camera.fy = 5250.0;
  const std::vector<std::uint16_t> pixels(640 * 480, 1500);
  PlaneSegmenter segmenter;
  segmenter.segment(viewOf(pixels.data(), 640, 480), camera);
  const auto is_row = [](const LineSegment& line) { return line.direction == ScanDirection::kRow; };
  const std::vector<LineSegment>& lines = segmenter.lineSegments();
  // Of 960 pixels: one row in 18 is scanned.
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), is_row), 27);
}

}  // namespace
}  // namespace line_plane_segmentation
