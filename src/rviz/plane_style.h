// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/Plane.h>

#include "line_plane_segmentation/palette.h"

namespace line_plane_segmentation {

/// Property of a plane that its colour represents.
enum class ColorBy : int { kId = 0, kOrientation = 1, kArea = 2 };

/// How planes are drawn.
struct PlaneStyle {
  ColorBy color_by = ColorBy::kId;
  float alpha = 0.5F;
  bool fill = true;
  bool outlines = true;
  bool normals = true;
  float normal_length = 0.3F;  ///< [m]
  bool ids = true;
  bool covariance = false;
  float covariance_scale = 20.0F;  ///< [-] radius of the disc in standard deviations
};

/// The plane's colour. By area: from blue at 0.1 m² to red at 10 m² and more.
Color colorOf(const Plane& plane, ColorBy color_by);

}  // namespace line_plane_segmentation
