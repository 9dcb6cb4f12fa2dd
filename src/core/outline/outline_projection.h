// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Carries rings of pixels along their rays onto a plane.
///
/// A labelled pixel may look past the plane's horizon, for noise lets points count that lie a little behind
/// it. So where rays get nearly parallel to the plane the picture is squeezed toward its part that sees the
/// plane well: everything stays finite and on the plane, and rings that do not cross in the picture do not
/// cross there.
class PlaneProjection {
 public:
  PlaneProjection(const CameraIntrinsics& camera, const SegmentedPlane& plane, int width, int height);

  /// False if no pixel sees the plane's front: it has no outline.
  bool isVisible() const { return visible_; }

  /// Appends a ring on the plane [m]. Where it enters or leaves the squeezed part of the picture a vertex is
  /// added.
  /// @return false if one of its vertices is not finite
  bool project(const std::vector<Eigen::Vector2d>& ring, std::vector<Eigen::Vector3f>& vertices) const;

 private:
  double facingOf(const Eigen::Vector2d& pixel) const { return facing_at_origin_ + gradient_.dot(pixel); }
  bool append(const Eigen::Vector2d& pixel, std::vector<Eigen::Vector3f>& vertices) const;

  CameraIntrinsics camera_;
  double d_;
  // How far a pixel's ray gets toward the plane for each metre of depth, -normal . ray: linear in the pixel.
  double facing_at_origin_ = 0.0;
  Eigen::Vector2d gradient_ = Eigen::Vector2d::Zero();
  double squeeze_ = 0.0;
  bool visible_ = false;
};

}  // namespace line_plane_segmentation
