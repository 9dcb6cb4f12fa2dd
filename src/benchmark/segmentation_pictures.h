// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "benchmark_frame.h"
#include "methods.h"

namespace line_plane_segmentation {

/// Runs every method on every frame once more and writes overlays of the labels to the folder:
/// FRAME.METHOD.png for each, and segmentations.png with a row for each frame and a column for each method.
/// @throws BadInput if a file cannot be written
void writeSegmentationPictures(const std::filesystem::path& folder, const std::vector<BenchmarkFrame>& frames,
                               const std::vector<BenchmarkMethod>& methods);

}  // namespace line_plane_segmentation
