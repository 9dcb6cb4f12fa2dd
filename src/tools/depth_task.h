// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "depth_frames.h"
#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Input and settings of segmentDepthImages().
struct DepthTask {
  std::vector<DepthFrame> frames;
  Parameters parameters;
  std::filesystem::path out;     ///< folder for the results
  std::filesystem::path report;  ///< HTML page; empty: none
  std::filesystem::path
      table;          ///< table from which the frames were read, protected from overwriting; empty: none
  bool redo = false;  ///< also segment frames that are finished, or whose results are of another sequence
  int jobs = 0;       ///< number of frames in parallel; 0: number of cores
};

/// Segments depth images on all cores; the results of each frame appear together. Frames that an earlier call
/// finished with the same image and settings are skipped. Prints a line per frame to stdout and the progress
/// to stderr.
/// @throws BadInput before anything is written if the input is invalid, except for damaged pixel data; later
/// if pixel data is damaged or the disk is full. The results of earlier frames are then complete.
void segmentDepthImages(const DepthTask& task);

}  // namespace line_plane_segmentation
