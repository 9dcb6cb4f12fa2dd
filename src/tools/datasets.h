// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "depth_frames.h"

namespace line_plane_segmentation {

/// Returns the names of the supported data sets: "tum, icl_nuim, nyu, 7scenes and scannet".
std::string datasetNames();

/// Describes the supported data sets, for --help.
std::string datasetHelp();

/// Returns the frames of a sequence in their order, with the depth unit and intrinsics of its data set.
/// @param dataset  "tum", whose intrinsics depend on the sequence's name, "icl_nuim", "nyu", "7scenes" or
/// "scannet"
/// @param folder   folder of one unpacked sequence
/// @param camera, depth_unit  replace the values of the data set
/// @throws BadInput if there is no such data set or folder, or no image in it
std::vector<DepthFrame> framesOfDataset(const std::string& dataset, const std::filesystem::path& folder,
                                        const std::optional<CameraIntrinsics>& camera,
                                        const std::optional<double>& depth_unit);

/// Returns the PNGs of a folder in natural order. If there are none, the images of the next format of
/// depthFormats(); if there are no images, those of the subfolder depth/. Results of segment_depth are
/// skipped.
/// @throws BadInput if there are none
std::vector<std::string> imagesIn(const std::filesystem::path& folder);

}  // namespace line_plane_segmentation
