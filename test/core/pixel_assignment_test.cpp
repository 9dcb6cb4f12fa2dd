// SPDX-License-Identifier: BSD-3-Clause
#include "refine/pixel_assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/clustered_image.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxSpeckle = 3;  // [px] runs as short may have been joined to their neighbours

/// An image with its clusters, and the labels of its pixels.
struct Assignment : ClusteredImage {
  DepthImage depth;
  Parameters parameters;
  std::vector<std::uint16_t> labels;  // kNoDepthLabel where there is no depth
  Creases creases;

  Assignment(const DepthImage& image, const Parameters& p, PixelAssigner& assigner)
      : ClusteredImage(image, p), depth(image), parameters(p) {
    creases.find(rays, grid, clusters, cluster_at);
    assign(assigner);
  }

  void assign(PixelAssigner& assigner) {
    LabelRuns runs;
    assigner.assign(depth, rays, grid, clusters, cluster_at, parameters, runs);
    labels.clear();
    for (const LabelRun& run : runs.runs) {
      EXPECT_EQ(depth.index(run.first, run.row), labels.size()) << "the runs cover the image";
      labels.insert(labels.end(), static_cast<std::size_t>(run.pixels()), run.label);
    }
    EXPECT_EQ(labels.size(), depth.z.size());
  }

  /// The error of a pixel to a plane, in tolerances.
  double errorTo(std::size_t cluster, int u, int v) const {
    const InverseDepthPlane& plane = clusters[cluster].plane;
    const DepthTolerance tolerance{parameters.noise, parameters.extraction.distance_noise_factor,
                                   parameters.extraction.plane_distance};
    const double w = 1.0 / static_cast<double>(depth.at(u, v));
    const double expected =
        plane.at(rays.x[static_cast<std::size_t>(u)], rays.y[static_cast<std::size_t>(v)]);
    return std::abs(w - expected) / tolerance.at(w, plane.inverseDistance());
  }

  /// The errors of a pixel to all planes, as text.
  std::string errorsAt(int u, int v) const {
    std::string text;
    for (std::size_t k = 0; k < clusters.size(); ++k)
      text += "\nplane " + std::to_string(k + 1) + (isNear(k, u, v) ? ", near: " : ": ") +
              std::to_string(errorTo(k, u, v));
    return text;
  }

  /// Whether a candidate of the cluster lies in the pixel's tile of the grid or in one of the eight around
  /// it.
  bool isNear(std::size_t cluster, int u, int v) const {
    const int column = std::min(u / grid.spacing, grid.columns - 1),
              row = std::min(v / grid.spacing, grid.rows - 1);
    for (std::size_t i = 0; i < grid.candidates.size(); ++i) {
      if (clusterOf(i) != static_cast<int>(cluster)) continue;
      const int cell = grid.candidates[i].cell;
      if (std::abs(cell % grid.columns - column) <= 1 && std::abs(cell / grid.columns - row) <= 1)
        return true;
    }
    return false;
  }

  /// The label by trying every plane, then at creases every other plane; `is_close` if rounding may decide
  /// otherwise.
  std::uint16_t bruteForceLabel(int u, int v, bool& is_close) const {
    const std::uint16_t label = bestLabel(u, v, is_close);
    if (label == 0 || label == kNoDepthLabel) return label;
    const double x = rays.x[static_cast<std::size_t>(u)], y = rays.y[static_cast<std::size_t>(v)];
    const std::size_t best = label - 1U;
    const DepthTolerance reach{parameters.noise, parameters.extraction.distance_noise_factor};
    std::uint16_t sided = label;
    int creases_here = 0;
    for (std::size_t k = 0; k < clusters.size(); ++k) {
      const CreaseType crease = creases.between(static_cast<int>(best), static_cast<int>(k));
      if (k == best || crease == CreaseType::kNone || !isNear(k, u, v)) continue;
      const double rho = clusters[best].plane.at(x, y), difference = rho - clusters[k].plane.at(x, y);
      // The reach is measured where the planes intersect in this row.
      const double intersection = x - difference / (clusters[best].plane.a - clusters[k].plane.a);
      const bool is_in_image = intersection >= rays.x.front() && intersection <= rays.x.back();
      const double in_reach =
          std::abs(difference) / reach.along(is_in_image ? clusters[best].plane.at(intersection, y) : rho);
      // Farther away than a tile, the reach is that of the border of the columns compared.
      const double tile = grid.spacing * static_cast<double>(rays.x[1] - rays.x[0]);
      is_close |= !is_in_image || std::abs(intersection - x) > tile;
      if (in_reach > 2.0) continue;
      ++creases_here;
      // The reach is that of the first row of a row of tiles.
      is_close |= in_reach > 0.5 || std::abs(difference) < 1e-4;
      if ((difference > 0.0) != (crease == CreaseType::kConcave)) sided = static_cast<std::uint16_t>(k + 1);
    }
    is_close |= creases_here > 1;
    return sided;
  }

  /// The label of the plane that fits best.
  std::uint16_t bestLabel(int u, int v, bool& is_close) const {
    if (!(depth.at(u, v) > 0.0F)) return kNoDepthLabel;
    double best = 1.0;
    std::uint16_t label = 0;
    for (std::size_t k = 0; k < clusters.size(); ++k) {
      if (!isNear(k, u, v)) continue;
      const double error = errorTo(k, u, v);
      is_close |= std::abs(error - best) < 2e-3;
      if (!(error < best)) continue;
      best = error;
      label = static_cast<std::uint16_t>(k + 1);
    }
    return label;
  }
};

void expectAsBruteForce(const Assignment& assignment) {
  const int width = assignment.depth.width;
  for (int v = 0; v < assignment.depth.height; ++v) {
    std::vector<std::uint16_t> expected;
    std::vector<bool> is_close;
    for (int u = 0; u < width; ++u) {
      bool close = false;
      expected.push_back(assignment.bruteForceLabel(u, v, close));
      is_close.push_back(close);
    }
    for (int first = 0, last = 0; first < width; first = last) {
      const auto label = [&](int u) { return expected[static_cast<std::size_t>(u)]; };
      const auto close_at = [&](int u) {
        return 0 <= u && u < width && is_close[static_cast<std::size_t>(u)];
      };
      while (last < width && label(last) == label(first) && close_at(last) == close_at(first)) ++last;
      for (int u = first; u < last; ++u) {
        const std::uint16_t found = assignment.labels[assignment.depth.index(u, v)];
        if (found == label(u) || is_close[static_cast<std::size_t>(u)]) continue;
        const bool is_speckle = last - first <= kMaxSpeckle && label(u) == 0 && first > 0 && last < width;
        ASSERT_TRUE(is_speckle && (found == label(first - 1) || found == label(last) || close_at(first - 1) ||
                                   close_at(last)))
            << u << ' ' << v << ": " << found << ", expected " << label(u) << assignment.errorsAt(u, v);
      }
    }
  }
}

TEST(PixelAssigner, GivesEachPixelToTheBestOfThePlanesNearby) {
  PixelAssigner assigner;
  std::size_t clusters = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const int width = random.integer(60, 240), height = random.integer(40, 180);
    Parameters parameters = adaptiveParameters(width);
    parameters.scanlines.scanline_spacing = random.integer(4, 12);
    parameters.extraction.distance_noise_factor = random.uniform(1.0, 5.0);
    parameters.extraction.plane_distance = random.uniform(0.001, 0.03);
    const Assignment assignment(randomScene(seed, width, height), parameters, assigner);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectAsBruteForce(assignment);
    if (testing::Test::HasFatalFailure()) return;
    clusters += assignment.clusters.size();
  }
  EXPECT_GT(clusters, 40U) << "the images are too poor to test anything";
}

// The noise of the pixels at a corner, more than a centimetre at 4 m, moves no pixel over the line where the
// walls meet.
TEST(PixelAssigner, PartsNoisyWallsAlongALine) {
  for (const double tilt : {0.6, -0.6}) {
    DepthImage depth = halves(surfaceAt(4.0, tilt), surfaceAt(4.0, -tilt), kinectCamera(640, 480), 640, 480);
    Random random(7);
    addNoise(NoiseParameters{}, 0.5, random, depth);
    PixelAssigner assigner;
    const Assignment assignment(depth, adaptiveParameters(640), assigner);
    ASSERT_EQ(assignment.clusters.size(), 2U);
    const std::uint16_t left = assignment.labels[depth.index(20, 240)],
                        right = assignment.labels[depth.index(620, 240)];
    int wrong = 0, judged = 0;
    for (int v = 0; v < 480; ++v) {
      for (int u = 300; u < 340; ++u) {
        const std::uint16_t label = assignment.labels[depth.index(u, v)];
        if (std::abs(u - 319.5) < 2.0 || (label != left && label != right)) continue;
        ++judged;
        wrong += label != (u < 320 ? left : right) ? 1 : 0;
      }
    }
    EXPECT_GT(judged, 15000);
    EXPECT_LT(wrong, 15) << tilt;
  }
}

TEST(PixelAssigner, PartsTwoWallsAlongTheirCorner) {
  const DepthImage depth =
      halves(surfaceAt(1.8, 0.6), surfaceAt(1.8, -0.6), kinectCamera(320, 240), 320, 240);
  PixelAssigner assigner;
  const Assignment assignment(depth, adaptiveParameters(320), assigner);
  ASSERT_EQ(assignment.clusters.size(), 2U);
  const std::uint16_t left = assignment.labels[depth.index(20, 100)],
                      right = assignment.labels[depth.index(300, 100)];
  EXPECT_NE(left, right);
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      if (std::abs(u - 159.5) < 1.0) continue;  // on the corner itself
      EXPECT_EQ(assignment.labels[depth.index(u, v)], u < 160 ? left : right) << u;
    }
  }
}

/// One plane with pixels of a row moved away, each by so many tolerances; the label of one of them.
std::uint16_t labelOfMovedPixels(const std::vector<double>& tolerances, int pixel = 0) {
  const Surface surface = surfaceAt(1.5);
  Parameters parameters = adaptiveParameters(320);
  parameters.extraction.plane_distance = 0.001;  // so that the tolerance is that of the noise
  PixelAssigner assigner;
  Assignment assignment(render(surface, kinectCamera(320, 240), 320, 240), parameters, assigner);
  const double sigma = parameters.extraction.distance_noise_factor * parameters.noise.sigma(1.5);
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    assignment.depth.row(100)[150 + i] = static_cast<float>(1.5 + tolerances[i] * sigma);
  assignment.assign(assigner);
  return assignment.labels[assignment.depth.index(150 + pixel, 100)];
}

/// The label of pixels between others of the plane, which lie 0.8 tolerances from it.
std::uint16_t labelOfSpeckle(const std::vector<double>& tolerances) {
  std::vector<double> moved(10, 0.8);
  moved.insert(moved.begin() + 5, tolerances.begin(), tolerances.end());
  return labelOfMovedPixels(moved, 5);
}

TEST(PixelAssigner, JoinsOverASpeckleNearThePlane) {
  EXPECT_EQ(labelOfMovedPixels(std::vector<double>(20, 0.95)), 1) << "within the tolerance";
  EXPECT_EQ(labelOfMovedPixels(std::vector<double>(20, 1.05)), 0) << "beyond it";
  EXPECT_EQ(labelOfSpeckle(std::vector<double>(kMaxSpeckle, 1.6)), 1) << "a speckle";
  EXPECT_EQ(labelOfSpeckle(std::vector<double>(kMaxSpeckle + 1, 1.6)), 0) << "too wide for a speckle";
  EXPECT_EQ(labelOfSpeckle(std::vector<double>(kMaxSpeckle, 2.1)), 0)
      << "over a tolerance from its neighbours";
  for (const std::vector<double>& speckle :
       {std::vector<double>{2.1, 1.6, 1.6}, {1.6, 2.1, 1.6}, {1.6, 1.6, 2.1}})
    EXPECT_EQ(labelOfSpeckle(speckle), 0) << "one of its pixels is";
}

TEST(PixelAssigner, OfNoPlanesOrNoDepthGivesNoLabels) {
  PixelAssigner assigner;
  const Assignment no_depth(blankDepth(60, 40), adaptiveParameters(60), assigner);
  EXPECT_EQ(std::count(no_depth.labels.begin(), no_depth.labels.end(), kNoDepthLabel), 60 * 40);
  Assignment no_planes(render(surfaceAt(1.5), kinectCamera(60, 40), 60, 40), adaptiveParameters(60),
                       assigner);
  no_planes.clusters.clear();
  std::fill(no_planes.cluster_at.begin(), no_planes.cluster_at.end(), -1);
  no_planes.assign(assigner);
  EXPECT_EQ(std::count(no_planes.labels.begin(), no_planes.labels.end(), 0), 60 * 40);
  const Assignment no_grid(render(surfaceAt(1.5), kinectCamera(2, 2), 2, 2), adaptiveParameters(320),
                           assigner);
  EXPECT_EQ(std::count(no_grid.labels.begin(), no_grid.labels.end(), 0), 4);
}

/// Two walls meet in a blunt edge. Pixels of the left one, from `nearest` to `farthest` beside the edge, are
/// moved into the plane of the right one.
/// @return whether these pixels are labelled as the left wall
bool isLeftWall(int nearest, int farthest) {
  const Surface left = surfaceAt(1.8, 0.15), right = surfaceAt(1.8, -0.15);
  const CameraIntrinsics camera = kinectCamera(320, 240);
  PixelAssigner assigner;
  Assignment assignment(halves(left, right, camera, 320, 240), adaptiveParameters(320), assigner);
  EXPECT_EQ(assignment.clusters.size(), 2U);
  paint(right, camera, {160 - farthest, 161 - nearest, 100, 101}, assignment.depth);
  assignment.assign(assigner);
  const auto labels = assignment.labels.begin() + static_cast<std::ptrdiff_t>(assignment.depth.index(0, 100));
  const std::uint16_t label = labels[20];
  EXPECT_EQ(labels[160 - nearest] == label, labels[160 - farthest] == label);
  return labels[160 - nearest] == label;
}

// A tolerance along the ray is seven to eight pixels here.
TEST(PixelAssigner, SplitsAtACreaseWithinATolerance) {
  EXPECT_TRUE(isLeftWall(1, 6));
  EXPECT_FALSE(isLeftWall(9, 12));
}

}  // namespace
}  // namespace line_plane_segmentation
