// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "depth_frames.h"
#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// What to do with depth images.
struct DepthTask {
  std::vector<DepthFrame> frames;
  Parameters parameters;
  std::filesystem::path out;     ///< folder for the results
  std::filesystem::path report;  ///< page to look at; empty: none
  bool redo = false;             ///< also what is finished
  int jobs = 0;                  ///< frames at a time; 0: as many as there are cores
};

/// Segments depth images on all cores; the results of each appear together. What an earlier call finished
/// with the same settings is left as it is. Says on stdout what was done, on stderr how far it is.
/// @throws BadInput before anything is written if something is wrong with the input; later if there is no
/// more room
void segmentDepthImages(const DepthTask& task);

}  // namespace line_plane_segmentation
