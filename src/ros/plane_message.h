// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/Plane.h>

#include "published_planes.h"

namespace line_plane_segmentation {

/// Returns the message of a plane without its polygons.
Plane planeWithoutPolygons(const PublishedPlane& published);

/// Writes normal, d [m] and covariance into the message.
void setCoefficients(const Eigen::Vector3d& normal, double d, const Eigen::Matrix4d& covariance,
                     Plane& message);

}  // namespace line_plane_segmentation
