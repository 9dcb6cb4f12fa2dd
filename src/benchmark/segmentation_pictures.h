// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmark_frame.h"
#include "contestants.h"

namespace line_plane_segmentation {

/// What methods find in frames, for people to look at.
struct SegmentationPictures {
  std::vector<std::pair<std::string, cv::Mat>> single;  ///< named "FRAME.METHOD", as large as the frame
  cv::Mat sheet;                                        ///< a row for each frame, a column for each method
};

/// Runs every method on every frame once more, and draws the labels that it gives over the depth image.
SegmentationPictures drawSegmentations(const std::vector<BenchmarkFrame>& frames,
                                       const std::vector<Contestant>& methods);

}  // namespace line_plane_segmentation
