// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/surface_patch.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// The pixels of a window of a scanline: (x, y, w) of those with a depth.
std::vector<Eigen::Vector3d> windowPixels(const DepthImage& depth, const ViewRays& rays, int u, int v,
                                          int half_u, int half_v) {
  std::vector<Eigen::Vector3d> pixels;
  for (int j = std::max(0, v - half_v); j <= std::min(depth.height - 1, v + half_v); ++j) {
    for (int i = std::max(0, u - half_u); i <= std::min(depth.width - 1, u + half_u); ++i) {
      if (!(depth.at(i, j) > 0.0F)) continue;
      pixels.emplace_back(rays.x[static_cast<std::size_t>(i)], rays.y[static_cast<std::size_t>(j)],
                          1.0 / static_cast<double>(depth.at(i, j)));
    }
  }
  return pixels;
}

/// Least squares of w = a x + b y + c, or of w = s t + c if only one coordinate is asked.
double squaredErrorOf(const std::vector<Eigen::Vector3d>& pixels, bool with_x, bool with_y,
                      Eigen::Vector3d& plane) {
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(pixels.size()), 1 + with_x + with_y);
  Eigen::VectorXd w(static_cast<Eigen::Index>(pixels.size()));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Eigen::Index column = 0;
    if (with_x) matrix(static_cast<Eigen::Index>(i), column++) = pixels[i].x();
    if (with_y) matrix(static_cast<Eigen::Index>(i), column) = pixels[i].y();
    w[static_cast<Eigen::Index>(i)] = pixels[i].z();
  }
  const Eigen::VectorXd solution = matrix.colPivHouseholderQr().solve(w);
  if (with_x && with_y) plane = solution;
  return (matrix * solution - w).squaredNorm();
}

PatchGrid detect(const DepthImage& depth, const Parameters& parameters) {
  PatchGrid grid;
  PatchDetector().detect(depth, raysOf(kinectCamera(depth.width, depth.height), depth.width, depth.height),
                         parameters, grid);
  return grid;
}

/// All patches, with fine ones wherever there are lines, none being called explained.
PatchLevels refineAll(const DepthImage& depth, const Parameters& parameters, std::uint8_t explained = 0) {
  const ViewRays rays = raysOf(kinectCamera(depth.width, depth.height), depth.width, depth.height);
  PatchDetector detector;
  PatchLevels levels;
  detector.detect(depth, rays, parameters, levels.coarse);
  detector.refine(depth, rays, parameters,
                  std::vector<std::uint8_t>(levels.coarse.patch_at.size(), explained), levels);
  return levels;
}

/// The patch of a crossing, or null.
const SurfacePatch* patchAt(const PatchGrid& grid, int column, int row) {
  const int patch = grid.patchAt(grid.indexOf(column, row));
  return patch < 0 ? nullptr : &grid.patches[static_cast<std::size_t>(patch)];
}

TEST(PatchDetector, IsLeastSquaresOverTheWindowsOfTwoScanlines) {
  PatchDetector detector;
  PatchGrid grid;
  int planar = 0, others = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const int width = random.integer(8, 100), height = random.integer(8, 80);
    const DepthImage depth = randomScene(seed, width, height);
    const ViewRays rays = raysOf(kinectCamera(width, height), width, height);
    Parameters parameters = adaptiveParameters(width);
    parameters.scanlines.scanline_spacing = random.integer(3, 12);
    parameters.lines.line_window = 2 * random.integer(2, 10) + 1;
    detector.detect(depth, rays, parameters, grid);
    const int half = parameters.lines.line_window / 2;
    const double min_points = 0.7 * parameters.lines.line_window;
    const DepthTolerance tolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                   parameters.patches.patch_distance};
    for (int r = 0; r < grid.rows; ++r) {
      for (int c = 0; c < grid.columns; ++c) {
        const SurfacePatch* const patch = patchAt(grid, c, r);
        const std::vector<Eigen::Vector3d> row =
            windowPixels(depth, rays, grid.pixelOf(c), grid.pixelOf(r), half, 0);
        const std::vector<Eigen::Vector3d> column =
            windowPixels(depth, rays, grid.pixelOf(c), grid.pixelOf(r), 0, half);
        if (static_cast<double>(std::min(row.size(), column.size())) < min_points) {
          ASSERT_EQ(patch, nullptr) << seed;
          ++others;
          continue;
        }
        std::vector<Eigen::Vector3d> both = row;
        both.insert(both.end(), column.begin(), column.end());
        Eigen::Vector3d plane;
        const double squared_error = squaredErrorOf(both, true, true, plane);
        double mean_w = 0.0;
        for (const Eigen::Vector3d& pixel : both) mean_w += pixel.z() / static_cast<double>(both.size());
        const double bound = std::pow(tolerance.at(mean_w, plane.norm()), 2);
        const double worst =
            std::max({squared_error / static_cast<double>(both.size()),
                      squaredErrorOf(row, true, false, plane) / static_cast<double>(row.size()),
                      squaredErrorOf(column, false, true, plane) / static_cast<double>(column.size())}) /
            (parameters.patches.patch_flatness * bound);
        if (std::abs(worst - 1.0) < 1e-6) continue;  // rounding may decide
        ASSERT_EQ(patch != nullptr, worst < 1.0) << seed;
        (patch != nullptr ? planar : others) += 1;
        if (patch == nullptr) continue;
        ASSERT_EQ(patch->u, grid.pixelOf(c));
        ASSERT_EQ(patch->v, grid.pixelOf(r));
        ASSERT_NEAR(patch->plane.a, plane.x(), 1e-7);
        ASSERT_NEAR(patch->plane.b, plane.y(), 1e-7);
        ASSERT_NEAR(patch->plane.c, plane.z(), 1e-7);
        ASSERT_NEAR(patch->squared_error, squared_error / bound, 1e-6 * (1.0 + patch->squared_error));
        ASSERT_EQ(patch->moments.pixels, static_cast<double>(both.size()));
        ASSERT_NEAR(patch->moments.one * bound, patch->moments.pixels, 1e-6) << "weighed by the tolerance";
      }
    }
  }
  EXPECT_GT(planar, 500);
  EXPECT_GT(others, 500);
}

TEST(PatchDetector, LaysItsGridOverTheWholeImage) {
  for (int width = 1; width < 60; ++width) {
    Parameters parameters = adaptiveParameters(64);
    parameters.scanlines.scanline_spacing = 7;
    const PatchGrid grid = detect(blankDepth(width, 25), parameters);
    int columns = 0;
    for (int u = 3; u < width; u += 7) EXPECT_EQ(grid.pixelOf(columns++), u);
    EXPECT_EQ(grid.columns, columns) << width;
    EXPECT_EQ(grid.rows, 4);
    EXPECT_EQ(grid.patch_at.size(), static_cast<std::size_t>(grid.columns * grid.rows));
    EXPECT_EQ(grid.has_line.size(), grid.patch_at.size());
    EXPECT_TRUE(grid.patches.empty());
  }
}

TEST(PatchDetector, FindsThePlaneOfANoisySurface) {
  Random random(7);
  const Surface surface = surfaceAt(2.0, 0.4, -0.3);
  DepthImage depth = render(surface, kinectCamera(320, 240), 320, 240);
  addNoise({}, 1.0, random, depth);
  const PatchGrid grid = detect(depth, adaptiveParameters(320));
  // All but the corners, whose windows are cut in half.
  EXPECT_GT(grid.patches.size(), 0.85 * grid.crossings());
  double mean_d = 0.0;
  for (const SurfacePatch& patch : grid.patches)
    mean_d += 1.0 / patch.plane.inverseDistance() / static_cast<double>(grid.patches.size());
  EXPECT_NEAR(mean_d, surface.d, 0.02);
}

TEST(PatchDetector, FindsNoPlaneAcrossAStepOrACrease) {
  const CameraIntrinsics camera = kinectCamera(320, 240);
  const Parameters parameters = adaptiveParameters(320);
  for (const bool is_step : {true, false}) {
    DepthImage depth = blankDepth(320, 240);
    paint(is_step ? surfaceAt(1.5) : surfaceAt(1.5, 0.8), camera, {0, 160, 0, 240}, depth);
    paint(is_step ? surfaceAt(1.6) : surfaceAt(1.5, -0.8), camera, {160, 320, 0, 240}, depth);
    const PatchGrid grid = detect(depth, parameters);
    for (int c = 0; c < grid.columns; ++c) {
      const int distance = std::abs(2 * grid.pixelOf(c) - 319) / 2;  // [px] to the edge
      const bool is_planar = patchAt(grid, c, grid.rows / 2) != nullptr;
      const bool has_room = grid.pixelOf(c) >= 7 && grid.pixelOf(c) < 313;
      if (distance < 3) {
        EXPECT_FALSE(is_planar) << is_step << ' ' << c;
      }
      if (distance > parameters.lines.line_window && has_room) {
        EXPECT_TRUE(is_planar) << is_step << ' ' << c;
      }
    }
  }
}

TEST(PatchDetector, FindsNothingWithoutDepth) {
  EXPECT_TRUE(detect(blankDepth(320, 240), adaptiveParameters(320)).patches.empty());
  EXPECT_TRUE(detect(blankDepth(0, 0), adaptiveParameters(320)).patches.empty());
  EXPECT_TRUE(detect(blankDepth(3, 3), adaptiveParameters(320)).patches.empty())
      << "before the first scanline";
}

TEST(PatchDetector, RefinesWhereThereAreLines) {
  const Surface surface = surfaceAt(1.5, 0.3, 0.2);
  const Parameters parameters = adaptiveParameters(320);
  const PatchLevels levels = refineAll(render(surface, kinectCamera(320, 240), 320, 240), parameters);
  EXPECT_EQ(levels.fine.spacing, parameters.scanlines.fine_spacing);
  EXPECT_EQ(levels.count(), static_cast<int>(levels.coarse.patches.size() + levels.fine.patches.size()));
  ASSERT_GT(levels.fine.patches.size(), levels.coarse.patches.size());
  const int spacing = levels.coarse.spacing;
  for (int c = -1; c <= levels.fine.columns; ++c)
    EXPECT_EQ(levels.tileColumn(c),
              std::clamp(levels.fine.pixelOf(c) / spacing, 0, levels.coarse.columns - 1));
  for (int r = -1; r <= levels.fine.rows; ++r)
    EXPECT_EQ(levels.tileRow(r), std::clamp(levels.fine.pixelOf(r) / spacing, 0, levels.coarse.rows - 1));
  for (int i = levels.firstFine(); i < levels.count(); ++i) {
    const SurfacePatch& patch = levels.patch(i);
    EXPECT_NEAR(1.0 / patch.plane.inverseDistance(), surface.d, 1e-3);
    const int cell = levels.fine.cells[static_cast<std::size_t>(i - levels.firstFine())];
    EXPECT_EQ(levels.fine.patchAt(cell), i - levels.firstFine());
    EXPECT_EQ(patch.u, levels.fine.pixelOf(cell % levels.fine.columns));
    EXPECT_EQ(patch.v, levels.fine.pixelOf(cell / levels.fine.columns));
  }
}

TEST(PatchDetector, RefinesNothingThatIsExplainedOrThatNobodyWants) {
  const DepthImage depth = render(surfaceAt(1.5), kinectCamera(320, 240), 320, 240);
  Parameters parameters = adaptiveParameters(320);
  EXPECT_TRUE(refineAll(depth, parameters, 1).fine.patches.empty());
  parameters.scanlines.fine_spacing = parameters.scanlines.scanline_spacing;
  const PatchLevels levels = refineAll(depth, parameters);
  EXPECT_TRUE(levels.fine.patches.empty());
  EXPECT_EQ(levels.fine.patchAt(0), -1);
  EXPECT_TRUE(refineAll(blankDepth(320, 240), adaptiveParameters(320)).fine.patches.empty());
  EXPECT_EQ(refineAll(blankDepth(0, 0), adaptiveParameters(320)).count(), 0);
  for (const int size : {1, 2, 3, 4}) {
    EXPECT_EQ(refineAll(blankDepth(size, 240), adaptiveParameters(320)).count(), 0) << size;
    EXPECT_EQ(refineAll(blankDepth(320, size), adaptiveParameters(320)).count(), 0) << size;
  }
}

TEST(PatchGrid, FindsTheTileOfAPixel) {
  const PatchGrid grid = detect(blankDepth(50, 30), adaptiveParameters(320));
  for (int v = -5; v < 40; ++v) {
    for (int u = -5; u < 60; ++u) {
      int nearest = -1, nearest_distance = 1 << 30;
      for (int i = 0; i < grid.columns * grid.rows; ++i) {
        const int du = 2 * (u - (i % grid.columns) * grid.spacing) - (grid.spacing - 1);
        const int dv = 2 * (v - (i / grid.columns) * grid.spacing) - (grid.spacing - 1);
        if (du * du + dv * dv < nearest_distance) {
          nearest = i;
          nearest_distance = du * du + dv * dv;
        }
      }
      ASSERT_EQ(grid.indexAt(u, v), nearest) << u << ", " << v;
    }
  }
}

}  // namespace
}  // namespace line_plane_segmentation
