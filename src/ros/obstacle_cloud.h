// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "line_plane_segmentation/ros/conversions.h"
#include "line_plane_segmentation/ros/robot_parameters.h"

namespace line_plane_segmentation {

/// Decides which planes are left out of the cloud without planes: all of them where no gravity frame is set,
/// those that the parameters name where its pose is known, none while tf does not know it, since walls would
/// then vanish.
/// @return for each label, true if its pixels are left out; [0], no plane, is false
std::vector<bool> removedLabels(const SegmentedFrame& frame, const ObstacleParameters& parameters);

/// The points of all pixels that lie on none of these planes. Unorganised, every number finite. Fields and
/// colours are those of the coloured cloud.
sensor_msgs::PointCloud2::Ptr cloudWithoutPlanes(const SegmentedFrame& frame,
                                                 const ObstacleParameters& parameters);

}  // namespace line_plane_segmentation
