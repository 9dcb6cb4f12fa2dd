// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "conversions.h"
#include "robot_parameters.h"

namespace line_plane_segmentation {

/// Selects the planes that are left out of ~cloud_without_planes: all planes if no gravity frame is set; the
/// planes selected by the parameters if its pose is known; no planes while tf does not know the pose, because
/// walls would otherwise disappear.
/// @return per label, true if its pixels are left out; element 0 (no plane) is false
std::vector<bool> removedLabels(const SegmentedFrame& frame, const ObstacleParameters& parameters);

/// Returns the points of all valid pixels that are on none of these planes. The cloud is unorganised and all
/// values are finite. Fields and colours are the same as in ~cloud.
sensor_msgs::PointCloud2::Ptr cloudWithoutPlanes(const SegmentedFrame& frame,
                                                 const ObstacleParameters& parameters);

}  // namespace line_plane_segmentation
