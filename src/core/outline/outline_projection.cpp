// SPDX-License-Identifier: BSD-3-Clause
#include "outline/outline_projection.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

/// Below this facing, about one degree, the picture is squeezed, so that no facing is below half of it:
/// a vertex is at most 100 times as deep as the plane is far.
constexpr double kLeastFacing = 0.02;

/// [m] A nearer plane goes through the camera, which sees its edge.
constexpr double kLeastDistance = 1e-6;

}  // namespace

PlaneProjection::PlaneProjection(const CameraIntrinsics& camera, const SegmentedPlane& plane, int width,
                                 int height)
    : camera_(camera), d_(plane.d) {
  gradient_ = {-plane.normal.x() / camera.fx, -plane.normal.y() / camera.fy};
  facing_at_origin_ = -plane.normal.z() - gradient_.dot(Eigen::Vector2d(camera.cx, camera.cy));
  // The extremes of a linear function over the picture are at its corners.
  const double left = facingOf({-0.5, -0.5}), across = gradient_.x() * width, down = gradient_.y() * height;
  const double least = left + std::min(across, 0.0) + std::min(down, 0.0);
  const double most = left + std::max(across, 0.0) + std::max(down, 0.0);
  visible_ = plane.d >= kLeastDistance && most > kLeastFacing && std::isfinite(most - least);
  squeeze_ = least < kLeastFacing ? 0.5 * kLeastFacing / (kLeastFacing - least) : 1.0;
}

bool PlaneProjection::project(const std::vector<Eigen::Vector2d>& ring,
                              std::vector<Eigen::Vector3f>& vertices) const {
  bool finite = true;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& pixel = ring[i];
    const Eigen::Vector2d& next = ring[i + 1 < ring.size() ? i + 1 : 0];
    finite &= append(pixel, vertices);
    const double before = facingOf(pixel) - kLeastFacing, after = facingOf(next) - kLeastFacing;
    if (before * after < 0.0)
      finite &= append(pixel + (next - pixel) * (before / (before - after)), vertices);
  }
  return finite;
}

bool PlaneProjection::append(const Eigen::Vector2d& pixel, std::vector<Eigen::Vector3f>& vertices) const {
  double facing = facingOf(pixel);
  Eigen::Vector2d at = pixel;
  if (facing < kLeastFacing) {
    const double squeezed = kLeastFacing - squeeze_ * (kLeastFacing - facing);
    at += gradient_ * ((squeezed - facing) / gradient_.squaredNorm());
    facing = squeezed;
  }
  const double depth = d_ / facing;
  const Eigen::Vector3d point((at.x() - camera_.cx) / camera_.fx * depth,
                              (at.y() - camera_.cy) / camera_.fy * depth, depth);
  vertices.push_back(point.cast<float>());
  return vertices.back().allFinite();
}

}  // namespace line_plane_segmentation
