// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// The picture of a segmentation for people: the depth image in grey, near light and far dark, each
/// plane tinted in its colour, with its outline, its number and an arrow along its normal.
/// @param depth  one 16-bit channel, of the size of the segmentation
/// @return 8-bit BGR of the same size
cv::Mat drawOverlay(const cv::Mat& depth, const Segmentation& segmentation, const CameraIntrinsics& camera);

}  // namespace line_plane_segmentation
