// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/pixel_sums.h"

/// The loops over the pixels of a row that all the time goes into, nearly all of them simple enough for the
/// compiler to vectorise.
namespace line_plane_segmentation {

/// Distance of a pixel's point to a plane, n . p + d = z (a + b x) + d, where x = (u - cx) / fx, b = nx and
/// a = ny (v - cy) / fy + nz are the same for the whole row.
inline float planeDistance(float z, float x, float a, float b, float d) { return z * (a + b * x) + d; }

/// mask[i] = 1 where z[i] is a depth whose point lies nearer than `threshold` to the plane, else 0.
void markInliers(const float* z, const float* x, int count, float a, float b, float d, float threshold,
                 std::uint8_t* mask);

/// How many pixels markInliers() would mark.
int countInliers(const float* z, const float* x, int count, float a, float b, float d, float threshold);

/// boundaries[i] = 1 where a run of marked, linked pixels begins or ends at i, else 0: mask[i] differs from
/// mask[i - 1], or both are set but not linked. Before the first pixel nothing is marked.
void markRunBoundaries(const std::uint8_t* mask, const std::uint8_t* links, int count,
                       std::uint8_t* boundaries);

/// Squared distance [m²] between the points of depths z0 and z1 on the rays (x0, y0, 1) and (x1, y1, 1).
inline float squaredDistance(float z0, float x0, float y0, float z1, float x1, float y1) {
  const float dx = z1 * x1 - z0 * x0, dy = z1 * y1 - z0 * y0, dz = z1 - z0;
  return dx * dx + dy * dy + dz * dz;
}

/// Bits of links[i].
constexpr std::uint8_t kLinkRight = 1;  ///< the pixel and its right neighbour are nearer than the bound
constexpr std::uint8_t kLinkDown = 2;   ///< the pixel and the one below are nearer than the bound

/// Which pixels of a row are linked to their right and lower neighbours. `below` may be null (the last row).
/// @param y, y_below  rays of the two rows
/// @param bound       [m²] squared neighbour distance
void linkNeighbors(const float* z, const float* below, const float* x, float y, float y_below, int count,
                   float bound, std::uint8_t* links);

/// changes[i] = 1 where labels[i] differs from labels[i - 1], else 0; changes[0] = 0.
void markChanges(const std::uint16_t* labels, int count, std::uint8_t* changes);

constexpr int kMarkBlock = 64;    ///< so many marks are read at a time
constexpr int kSpareColumns = 4;  ///< so many columns may be written behind the last one

/// Appends to `columns` the i from 0 to count - 1 where marks[i] is 1, in order; the others are 0, also those
/// behind them up to a whole number of blocks.
/// @return the end of what was appended
int* compactIndices(const std::uint8_t* marks, int count, int* columns);

/// The noise model times a factor: floor and growth are multiplied by it.
struct RowNoise {
  float floor, growth, nearest;
};

/// Makes a row ready for assignIfBetter().
/// @param depth_over_noise  [-] z over its noise, sigma_z times the factor; undefined where there is no depth
/// @param best              1: a pixel must lie within the tolerance; 0 where there is no depth: nothing is
/// better
/// @param label             0, or kNoDepthLabel where there is no depth
void prepareRow(const float* z, int count, const RowNoise& noise, float* depth_over_noise, float* best,
                std::uint16_t* label);

/// A plane along a row: its inverse depth is slope * x + offset.
struct RowOfPlane {
  float slope, offset;
  float inv_orthogonal_tolerance;  ///< [-] the plane's distance to the camera, divided by the orthogonal
                                   ///< tolerance
  std::uint16_t label;
};

/// Gives each pixel whose error, in tolerances, is under `best` to the plane, and remembers the error there.
/// With w = 1/z, w_p the plane's inverse depth there, and DepthTolerance's tolerance max(sigma_z w², distance
/// w / d), the error is |w - w_p| / tolerance = |1 - z w_p| min(z / sigma_z, d / distance).
void assignIfBetter(const float* z, const float* depth_over_noise, const float* x, int count,
                    const RowOfPlane& plane, float* best, std::uint16_t* label);

/// Adds a run of `count` pixels of one row. The order of summation is fixed: the same bits on every machine.
/// @param z  finite, as all depths are
void addRun(const float* z, const double* x, double y, int count, PixelSums& sums);

}  // namespace line_plane_segmentation
