// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "depth_frames.h"
#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Where the results of a frame are, in the folder for all results.
struct FrameResults {
  FrameResults(const std::filesystem::path& folder, const DepthFrame& frame);

  std::array<std::filesystem::path, 3> all() const { return {labels, overlay, planes}; }

  std::filesystem::path labels;   ///< NAME.labels.png
  std::filesystem::path overlay;  ///< NAME.overlay.png
  std::filesystem::path planes;   ///< NAME.planes.json, which is made last
};

/// All that the results of a frame depend on, but for its image: camera, depth scale, parameters, version.
nlohmann::json settingsOf(const DepthFrame& frame, const Parameters& parameters);

/// True if the results are there, made with these settings, and not older than the image.
bool areFinished(const FrameResults& results, const DepthFrame& frame, const nlohmann::json& settings);

}  // namespace line_plane_segmentation
