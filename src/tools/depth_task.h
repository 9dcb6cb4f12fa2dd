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
  std::filesystem::path table;   ///< table of frames that was read, which is not overwritten; empty: none
  bool redo = false;             ///< also frames that are finished, or whose results are of another sequence
  int jobs = 0;                  ///< frames at a time; 0: as many as there are cores
};

/// Segments depth images on all cores; the results of each frame appear together. Frames that an earlier call
/// finished with the same image and settings are skipped. Prints a line per frame to stdout and the progress
/// to stderr.
/// @throws BadInput before anything is written if the input is wrong, except for damaged pixel data within an
/// image; later if that is found or the disk is full. The results of earlier frames are complete then.
void segmentDepthImages(const DepthTask& task);

}  // namespace line_plane_segmentation
