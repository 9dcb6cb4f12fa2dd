// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/eigen_types.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Transforms coefficients, their covariance and the centroid of a plane from the optical frame to another
/// one. The normal still points towards the camera, which need not be at the origin, so d can be negative.
/// @param target_from_optical  maps points of the optical frame to the target frame
SegmentedPlane transformed(const SegmentedPlane& plane, const RigidTransform& target_from_optical);

}  // namespace line_plane_segmentation
