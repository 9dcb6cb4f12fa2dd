// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/eigen_types.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// A plane of the optical frame as another frame has it: coefficients, their covariance and the centroid. The
/// normal still points toward the camera, wherever that is; so d may be negative.
/// @param placement  takes points of the optical frame to the other one
SegmentedPlane transformed(const SegmentedPlane& plane, const RigidTransform& placement);

}  // namespace line_plane_segmentation
