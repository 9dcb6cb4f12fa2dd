// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "depth_frames.h"

namespace line_plane_segmentation {

/// The names of the data sets whose layout is known: "tum, icl_nuim, nyu and 7scenes".
std::string datasetNames();

/// What is known of the data sets, for --help.
std::string datasetHelp();

/// The frames of a sequence of a data set, in their order, with its depth scale and intrinsics.
/// @param dataset  "tum", whose intrinsics go by the sequence's name, "icl_nuim", "nyu" or "7scenes"
/// @param folder   of one sequence, as it is when unpacked
/// @param camera, units_per_metre  in place of the data set's own
/// @throws BadInput if there is no such data set or folder, or no image in it
std::vector<DepthFrame> framesOfDataset(const std::string& dataset, const std::filesystem::path& folder,
                                        const std::optional<CameraIntrinsics>& camera,
                                        const std::optional<double>& units_per_metre);

/// The PNGs of a folder, or if it has none of its subfolder depth/, in their order: numbers in their names
/// count as numbers. Results of segment_depth are passed over.
/// @throws BadInput if there are none
std::vector<std::string> imagesIn(const std::filesystem::path& folder);

}  // namespace line_plane_segmentation
