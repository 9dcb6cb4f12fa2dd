// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/SupportedObjectArray.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <vector>

#include "conversions.h"
#include "object_detection.h"

namespace line_plane_segmentation {

/// Returns the indices in Segmentation::planes of the published planes that are horizontal and visible from
/// above.
std::vector<std::size_t> supportsOf(const SegmentedFrame& frame);

/// Returns the message of all objects, in the target frame.
/// @param supports  planes on which objects were searched, as indices in Segmentation::planes
SupportedObjectArray::Ptr objectsMessage(const SegmentedFrame& frame,
                                         const std::vector<DetectedObject>& objects,
                                         const std::vector<std::size_t>& supports);

/// Appends a translucent box per object (namespace "objects").
void addObjectMarkers(const SegmentedFrame& frame, const std::vector<DetectedObject>& objects,
                      visualization_msgs::MarkerArray& markers);

}  // namespace line_plane_segmentation
