// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/region_cleanup_reference.h"
#include "refine/region_cleanup.h"
#include "support/clustered_image.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

using Labels = std::vector<std::uint16_t>;

constexpr int kPlanes = 3;

/// Planes that lie near each other or a step apart, in upright bands, with speckles of any label in them.
/// Depths are those of the planes, bent and moved by about what is tolerated.
struct Clutter {
  int width, height;
  DepthImage depth;
  ViewRays rays;
  std::vector<PlaneCluster> clusters;
  Labels labels;
  Parameters parameters;

  explicit Clutter(Random& random) : width(random.integer(4, 28)), height(random.integer(1, 20)) {
    const CameraIntrinsics camera = kinectCamera(width, height);
    rays = raysOf(camera, width, height);
    depth = blankDepth(width, height);
    parameters = adaptiveParameters(width);
    parameters.cleanup.min_region_pixels = random.integer(2, 12);
    parameters.extraction.min_plane_inliers = 0;
    parameters.extraction.plane_distance = random.uniform(0.0, 0.03);
    paintBands(camera, random);
    for (int i = random.integer(2, 25); i > 0; --i) addSpeckle(random);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (random.chance(0.02)) labels[i] = kNoDepthLabel;
      if (labels[i] == kNoDepthLabel) depth.z[i] = 0.0F;
    }
  }

 private:
  void paintBands(const CameraIntrinsics& camera, Random& random) {
    labels.assign(depth.z.size(), 0);
    int first = 0;
    for (int k = 0; k < kPlanes; ++k) {
      const Surface plane =
          surfaceAt(random.uniform(1.4, 1.5), random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15));
      clusters.push_back(clusterOf(plane));
      const int last = k + 1 < kPlanes ? random.integer(first, width) : width;
      paint(plane, camera, {first, last, 0, height}, depth);
      for (int v = 0; v < height; ++v) {
        for (int u = first; u < last; ++u) labels[depth.index(u, v)] = static_cast<std::uint16_t>(k + 1);
      }
      first = last;
    }
  }

  /// A rectangle of another label, lifted off its plane, whose surface may lean and be rough.
  void addSpeckle(Random& random) {
    const int kind = random.integer(0, 6);
    const std::uint16_t label = kind > kPlanes + 2 ? kNoDepthLabel : static_cast<std::uint16_t>(kind % 4);
    const int first_u = random.integer(0, width - 1), first_v = random.integer(0, height - 1);
    const int last_u = std::min(width, first_u + random.integer(1, 6));
    const int last_v = std::min(height, first_v + random.integer(1, 6));
    const double unit = parameters.extraction.distance_noise_factor * parameters.noise.sigma(1.5);
    const double lift = random.chance(0.5) ? 0.0 : random.uniform(-2.5, 2.5) * unit;
    const double lean = random.chance(0.5) ? 0.0 : random.uniform(-0.9, 0.9) * unit;
    const double roughness = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.5) * unit;
    for (int v = first_v; v < last_v; ++v) {
      for (int u = first_u; u < last_u; ++u) {
        const double moved = lift + lean * (u - first_u) + roughness * random.gaussian();
        depth.z[depth.index(u, v)] += static_cast<float>(moved);
        labels[depth.index(u, v)] = label;
      }
    }
  }
};

/// As RegionCleaner has it, with the numbers of the clusters.
Labels cleaned(const Clutter& clutter, RegionCleaner& cleaner) {
  LabelRuns runs;
  runs.scan(clutter.labels, clutter.width, clutter.height);
  cleaner.clean(clutter.depth, clutter.rays, clutter.clusters, clutter.parameters, runs);
  Labels labels(clutter.labels.size());
  runs.write(labels, clutter.width);
  for (std::uint16_t& label : labels)
    label = label == 0 ? label : static_cast<std::uint16_t>(cleaner.clusterOf(label) + 1);
  return labels;
}

TEST(RegionCleanerFuzzTest, DoesWhatGoingPixelByPixelDoes) {
  RegionCleaner cleaner;
  int given = 0, left_alone = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    const Clutter clutter(random);
    const Labels expected =
        referenceCleanup(clutter.depth, clutter.rays, clutter.clusters, clutter.parameters, clutter.labels);
    ASSERT_EQ(cleaned(clutter, cleaner), expected) << "seed " << seed;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      given += expected[i] != clutter.labels[i] && expected[i] != 0 ? 1 : 0;
      left_alone += clutter.labels[i] == 0 && expected[i] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(given, 2000) << "too little happens to test anything";
  EXPECT_GT(left_alone, 2000);
}

}  // namespace
}  // namespace line_plane_segmentation
