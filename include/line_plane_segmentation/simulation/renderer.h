// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/simulation/scene.h"

namespace line_plane_segmentation::simulation {

/// A visible plane: all p with normal . p + d = 0, in the optical frame.
struct VisiblePlane {
  std::uint16_t label = 0;                           ///< of its pixels
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, toward the camera
  double d = 0.0;                                    ///< [m] distance to the camera, positive
  std::uint32_t pixels = 0;                          ///< that show it, at least 1
};

/// Images of a perfect camera, row by row, width * height pixels each.
struct Rendering {
  int width = 0;                      ///< [px]
  int height = 0;                     ///< [px]
  std::vector<float> depth;           ///< [m] along the optical axis, 0 where nothing is hit
  std::vector<std::uint16_t> labels;  ///< the scene's labels, 0 = nothing, or a curved surface
  std::vector<VisiblePlane> planes;   ///< in the order of their labels
};

/// Casts the ray of each pixel's centre to the nearest surface of the scene. The planes that are reported
/// are the scene's own, depth and labels follow from them by calculation alone: exact but for rounding.
///
/// @param scene   in the world frame
/// @param camera  pose of the optical frame (x right, y down, z forward) in the world
/// @param width,height  [px], not negative
/// @param rendering     overwritten; its memory is used again
/// @throw std::invalid_argument  if the intrinsics are not valid or the size is negative
void render(const Scene& scene, const Eigen::Isometry3d& camera, const CameraIntrinsics& intrinsics,
            int width, int height, Rendering& rendering);

/// The depth as a 16-bit depth image (REP 118) without any noise: rounded to millimetres, 0 = no depth,
/// also for what lies beyond 65.535 m.
/// @param depth_mm  [mm] width * height pixels
void toMillimetres(const Rendering& rendering, std::uint16_t* depth_mm);

}  // namespace line_plane_segmentation::simulation
