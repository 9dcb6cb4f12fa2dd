// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "depth_frames.h"

namespace line_plane_segmentation {

/// The names of the data sets whose layout is known: "tum, icl_nuim, nyu, 7scenes and scannet".
std::string datasetNames();

/// Describes the known data sets, for --help.
std::string datasetHelp();

/// The frames of a sequence of a data set, in their order, with its depth unit and intrinsics.
/// @param dataset  "tum", whose intrinsics depend on the sequence's name, "icl_nuim", "nyu", "7scenes" or
/// "scannet"
/// @param folder   of one sequence, as it is when unpacked
/// @param camera, depth_unit  in place of the data set's own
/// @throws BadInput if there is no such data set or folder, or no image in it
std::vector<DepthFrame> framesOfDataset(const std::string& dataset, const std::filesystem::path& folder,
                                        const std::optional<CameraIntrinsics>& camera,
                                        const std::optional<double>& depth_unit);

/// The PNGs of a folder, ordered by name with numbers compared as numbers. Without PNGs, the images of the
/// first other format of depthFormats(); without any, those of its subfolder depth/. Results of segment_depth
/// are skipped.
/// @throws BadInput if there are none
std::vector<std::string> imagesIn(const std::filesystem::path& folder);

}  // namespace line_plane_segmentation
