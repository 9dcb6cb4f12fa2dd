// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"

namespace line_plane_segmentation {

/// A plane as the report shows it.
struct ReportPlane {
  std::uint16_t label = 0;
  std::array<double, 3> normal{};
  double d = 0.0;     ///< [m]
  double area = 0.0;  ///< [m²]
  double rms = 0.0;   ///< [m]
  std::uint32_t inliers = 0;
};

/// What the report tells of a frame.
struct ReportFrame {
  std::string name;
  std::vector<ReportPlane> planes;
  std::array<double, kStageCount> stage_milliseconds{};
  double milliseconds = 0.0;
};

/// Reads it from the frame's NAME.planes.json.
/// @throws BadInput if it cannot be read
ReportFrame readReportFrame(const std::filesystem::path& planes_json);

}  // namespace line_plane_segmentation
