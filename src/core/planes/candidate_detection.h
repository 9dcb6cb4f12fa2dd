// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// The square of pixels around a candidate, cut off at the image's border: columns first_u to last_u - 1,
/// rows first_v to last_v - 1.
struct PixelWindow {
  int first_u, last_u, first_v, last_v;
};

PixelWindow windowAround(int u, int v, int side, int width, int height);

/// Stage 3: a local plane by PCA in the window around 1, 3 or 5 points of each segment. Kept are those whose
/// window holds points enough and is flat enough.
/// @param parameters  resolved for the width of the image
void detectCandidates(const DepthImage& depth, const ViewRays& rays, const std::vector<LineSegment>& segments,
                      const CandidateParameters& parameters, std::vector<PlaneCandidate>& candidates);

}  // namespace line_plane_segmentation
