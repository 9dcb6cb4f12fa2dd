// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Draws a segmentation over its depth image: drawDepthOverlay(), and each plane's outline, number and
/// normal.
/// @param depth  of the size of the segmentation
/// @return 8-bit BGR of the same size
cv::Mat drawOverlay(const DepthView& depth, const Segmentation& segmentation, const CameraIntrinsics& camera);

}  // namespace line_plane_segmentation
