// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Stage 4, Algorithm 2: takes the candidate with the most inliers, deletes these, and so on, until no
/// candidate has enough. Inliers of a candidate are the pixels that are not yet taken, lie nearer than
/// plane_distance to its plane, and can be reached from the candidate's pixel over such pixels, side by side
/// or one above the other, each nearer than neighbor_distance to the next.
///
/// The result is that of counting every candidate anew in each round, as the paper has it; but since counts
/// only fall, a candidate is counted only when its last count, or a bound from tiles of the image, tops all
/// others (lazy greedy evaluation). Of candidates with equal counts the first one goes first.
class PlaneExtractor {
 public:
  PlaneExtractor();
  ~PlaneExtractor();

  /// @param parameters  resolved for the width of the image
  /// @param labels      width * height, all 0; plane k's inliers become k, in the order of extraction from 1
  /// @param observer    asked for a stop before each candidate is counted; may be null
  /// @return the number of planes
  int extract(const DepthImage& depth, const ViewRays& rays, const std::vector<PlaneCandidate>& candidates,
              const Parameters& parameters, std::vector<std::uint16_t>& labels,
              StageObserver* observer = nullptr);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace line_plane_segmentation
