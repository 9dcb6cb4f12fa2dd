// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/Plane.h>

#include "line_plane_segmentation/ros/published_planes.h"

namespace line_plane_segmentation {

/// All of a plane's message but its polygons.
Plane planeWithoutPolygons(const PublishedPlane& published);

/// Writes normal, d and covariance.
void setCoefficients(const Eigen::Vector3d& normal, double d, const Eigen::Matrix4d& covariance,
                     Plane& message);

}  // namespace line_plane_segmentation
