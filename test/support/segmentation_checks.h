// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth/depth_image.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Expects that all parts of a result tell the same: labels, planes, counts and rings, everything finite.
/// @param depth  the image that was segmented
void expectConsistent(const Segmentation& segmentation, const DepthImage& depth);

/// Expects that two results are equal, bit by bit.
void expectSameBits(const Segmentation& a, const Segmentation& b);

}  // namespace line_plane_segmentation
