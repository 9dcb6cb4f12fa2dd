// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <jsk_recognition_msgs/ModelCoefficientsArray.h>
#include <jsk_recognition_msgs/PolygonArray.h>
#include <line_plane_segmentation/PlaneArray.h>

namespace line_plane_segmentation {

/// Returns the outline of each plane, with its id as the label. Compiled only if jsk_recognition_msgs is
/// installed.
jsk_recognition_msgs::PolygonArray::Ptr jskPolygons(const PlaneArray& planes);

/// Returns the coefficients of each plane, in the order of the polygons.
jsk_recognition_msgs::ModelCoefficientsArray::Ptr jskCoefficients(const PlaneArray& planes);

}  // namespace line_plane_segmentation
