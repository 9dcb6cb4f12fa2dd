// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "depth_task.h"

namespace line_plane_segmentation {

/// Writes one page, whole in this file, about the results of all frames of a task, which have to be there: a
/// plot of times and planes over the frames; for each frame its overlay, planes and times. Of more than 200
/// frames, 200 that are evenly spread have their overlays.
/// @throws BadInput if results cannot be read or the page cannot be written
void writeHtmlReport(const std::filesystem::path& file, const DepthTask& task);

}  // namespace line_plane_segmentation
