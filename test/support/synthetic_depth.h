// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "support/random.h"

/// Small depth images of a few planes, made for tests: what is in them is known exactly.
namespace line_plane_segmentation {

/// All p with normal . p + d = 0, in the optical frame.
struct Surface {
  Eigen::Vector3d normal;
  double d;

  /// Depth [m] at which the ray (x, y, 1) meets the surface; not positive if it does not.
  double depthAlong(double x, double y) const { return -d / normal.dot(Eigen::Vector3d(x, y, 1.0)); }
};

/// The surface that meets the optical axis at `distance` [m] and is turned from facing the camera by
/// `yaw` about the vertical and by `pitch` about the horizontal axis [rad].
Surface surfaceAt(double distance, double yaw = 0.0, double pitch = 0.0);

/// Columns first_u to last_u - 1, rows first_v to last_v - 1.
struct Region {
  int first_u, last_u, first_v, last_v;
};

/// A camera with the field of view of a Kinect for an image of this size.
CameraIntrinsics kinectCamera(int width, int height);

ViewRays raysOf(const CameraIntrinsics& camera, int width, int height);

/// An image without any depth.
DepthImage blankDepth(int width, int height);

/// Paints the surface, as far as 20 m, over what is in the region.
void paint(const Surface& surface, const CameraIntrinsics& camera, const Region& region, DepthImage& depth);

/// An image of one surface.
DepthImage render(const Surface& surface, const CameraIntrinsics& camera, int width, int height);

/// An image of two surfaces, one left of the other, parted in the middle.
DepthImage halves(const Surface& left, const Surface& right, const CameraIntrinsics& camera, int width,
                  int height);

/// Moves every depth by the noise of Eq. 5 times `factor`.
void addNoise(const NoiseParameters& noise, double factor, Random& random, DepthImage& depth);

/// Sets a fraction of the pixels, and a few patches, to invalid depth.
void addHoles(double fraction, int patches, Random& random, DepthImage& depth);

/// A tilted background with patches of other planes before it: depth steps, creases, noise and holes, as the
/// seed has it. Some scenes are free of noise and made of equal squares, so that planes of equal size occur.
DepthImage randomScene(std::uint64_t seed, int width, int height);

/// The depths as a sensor with whole millimetres gives them.
std::vector<std::uint16_t> toMillimetres(const DepthImage& depth);

/// Point [m] of a pixel, in double precision.
Eigen::Vector3d pointAt(const DepthImage& depth, const ViewRays& rays, int u, int v);

}  // namespace line_plane_segmentation
