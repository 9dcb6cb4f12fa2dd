// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"
#include "planes/plane_fit.h"

namespace line_plane_segmentation {

struct ReferenceResult {
  std::vector<std::uint16_t> labels;
  std::vector<std::optional<PlaneFit>> planes;  ///< none where the inliers are of one row or column
};

/// Algorithm 2 as the paper writes it, plain and slow: in every round each candidate that is left is counted
/// anew, by a flood fill pixel by pixel; the one with the most inliers is refitted by PCA over them, saved,
/// and its inliers are deleted. Of candidates with equal counts the first one goes first.
/// @param parameters  resolved for the width of the image
ReferenceResult referenceExtraction(const DepthImage& depth, const ViewRays& rays,
                                    std::vector<PlaneCandidate> candidates, const Parameters& parameters);

}  // namespace line_plane_segmentation
