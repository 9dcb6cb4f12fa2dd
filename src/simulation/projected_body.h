// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "image_row.h"
#include "scene.h"

namespace line_plane_segmentation::simulation {

/// Projection of a curved body. With o the camera and q a pixel's ray in the frame where the body
/// is the unit sphere, the ray meets it at the depth z where |o + z q| = 1.
class ProjectedBody {
 public:
  /// @param camera  pose of the optical frame in the world
  ProjectedBody(const CurvedBody& body, const Eigen::Isometry3d& camera, const CameraIntrinsics& k);

  /// Returns true if the camera is outside of the body, or inside of the vault.
  bool visible() const { return vault_ ? c_ < 0.0 : c_ > 0.0; }

  /// Renders the body, which has to be visible, into row `v` where it is nearer than the surfaces there.
  void draw(int v, ImageRow& row) const;

 private:
  bool vault_;
  double c_ = 0.0;          // |o|^2 - 1
  LinearInPixels b_;        // o . q
  LinearInPixels q_[3];     // the coordinates of q
  LinearInPixels climb_;    // [m] that the ray rises in the world for each metre of depth
  double springing_ = 0.0;  // [m] height of the body's centre over the camera, where a vault begins
};

}  // namespace line_plane_segmentation::simulation
