// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "benchmark_frame.h"

namespace line_plane_segmentation {

/// The frames of a folder with a table frames.csv and the images in depth/.
/// @throws BadInput if something cannot be read
std::vector<BenchmarkFrame> recordedFrames(const std::filesystem::path& folder);

/// Depth images of a simulated Kinect in furnished rooms, one per room; the same on every machine.
/// @param count  number of rooms
std::vector<BenchmarkFrame> simulatedRooms(int count, int width, int height);

/// Depth image of `planes` tilted tiles side by side, which fill most of it; of balls if `planes` is 0.
/// @param planes  0 to 100
BenchmarkFrame simulatedTiles(int planes, int width, int height);

/// Every second pixel of every second row, which is how the paper makes QVGA from VGA.
BenchmarkFrame halved(const BenchmarkFrame& frame);

}  // namespace line_plane_segmentation
