// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "depth_frames.h"
#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Paths of the results of a frame in the folder for all results.
struct FrameResults {
  FrameResults(const std::filesystem::path& folder, const DepthFrame& frame);

  std::array<std::filesystem::path, 3> all() const { return {labels, overlay, planes}; }

  std::filesystem::path labels;   ///< NAME.labels.png
  std::filesystem::path overlay;  ///< NAME.overlay.png
  std::filesystem::path planes;   ///< NAME.planes.json, which records the provenance of all three
};

/// Everything that the results of a frame depend on, except its image: camera, depth unit, parameters,
/// version.
nlohmann::json settingsOf(const DepthFrame& frame, const Parameters& parameters);

/// Contents of the files that NAME.planes.json records.
struct FrameFiles {
  const std::vector<unsigned char>& image;
  const std::vector<unsigned char>& labels;
  const std::vector<unsigned char>& overlay;
};

/// Members of NAME.planes.json besides the planes and times: "settings"; "input", the image's path, size
/// [bytes] and SHA-256; "outputs", size and SHA-256 of the labels and the overlay.
nlohmann::json provenanceOf(const DepthFrame& frame, const nlohmann::json& settings, const FrameFiles& files);

enum class ResultState {
  kUnfinished,  ///< missing, incomplete, or made with other settings, from another version of the image, or
                ///< before it
  kFinished,    ///< complete, and made from this image with these settings
  kForeign,     ///< made from the image of another sequence that has the same name
};

/// Compares the results of a frame with its image and these settings, by size and SHA-256.
ResultState stateOf(const FrameResults& results, const DepthFrame& frame, const nlohmann::json& settings);

}  // namespace line_plane_segmentation
