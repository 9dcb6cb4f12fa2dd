// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "scene.h"

namespace line_plane_segmentation::simulation {

/// Visible plane: all points p with normal . p + d = 0, in the optical frame.
struct VisiblePlane {
  std::uint16_t label = 0;                           ///< label of its pixels
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit normal, towards the camera
  double d = 0.0;                                    ///< [m] distance to the camera, positive
  std::uint32_t pixels = 0;                          ///< number of its pixels, at least 1
};

/// Images of a perfect camera, row by row, width * height pixels each.
struct Rendering {
  int width = 0;                      ///< [px]
  int height = 0;                     ///< [px]
  std::vector<float> depth;           ///< [m] along the optical axis, 0 if the ray hits nothing
  std::vector<std::uint16_t> labels;  ///< the scene's labels, 0 = nothing, or a curved surface
  std::vector<VisiblePlane> planes;   ///< in the order of their labels
};

/// Intersects the ray of each pixel's centre with the nearest surface of the scene. Planes are those of the
/// scene; depth and labels are exact except for rounding.
///
/// @param scene   in the world frame
/// @param camera  pose of the optical frame (x right, y down, z forward) in the world
/// @param width,height  [px], not negative
/// @param rendering  output; its memory is reused
/// @throw std::invalid_argument  if the intrinsics are not valid or the size is negative
void render(const Scene& scene, const Eigen::Isometry3d& camera, const CameraIntrinsics& intrinsics,
            int width, int height, Rendering& rendering);

/// Converts the depth to a 16-bit depth image (REP 118) without noise: rounded to millimetres, 0 = invalid,
/// also beyond 65.535 m.
/// @param depth_mm  [mm] output, width * height pixels
void toMillimetres(const Rendering& rendering, std::uint16_t* depth_mm);

}  // namespace line_plane_segmentation::simulation
