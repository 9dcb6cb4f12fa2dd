// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/SupportedObjectArray.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <vector>

#include "line_plane_segmentation/robot/object_detection.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {

/// Indices, in Segmentation::planes, of the published planes that are horizontal and visible from above.
std::vector<std::size_t> supportsOf(const SegmentedFrame& frame);

/// @param supports  those on which objects were looked for
SupportedObjectArray::Ptr objectsMessage(const SegmentedFrame& frame,
                                         const std::vector<DetectedObject>& objects,
                                         const std::vector<std::size_t>& supports);

/// Adds a translucent box for each object (namespace "objects").
void addObjectMarkers(const SegmentedFrame& frame, const std::vector<DetectedObject>& objects,
                      visualization_msgs::MarkerArray& markers);

}  // namespace line_plane_segmentation
