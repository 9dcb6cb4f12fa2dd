// SPDX-License-Identifier: BSD-3-Clause
#include "report_frame.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "run_tool.h"

namespace line_plane_segmentation {

ReportFrame readReportFrame(const std::filesystem::path& planes_json) {
  try {
    std::ifstream stream(planes_json);
    const nlohmann::json document = nlohmann::json::parse(stream);
    ReportFrame frame;
    frame.name = document.at("frame");
    for (const nlohmann::json& plane : document.at("planes")) {
      frame.planes.push_back({plane.at("label"), plane.at("normal"), plane.at("d"), plane.at("area"),
                              plane.at("rms"), plane.at("inliers")});
    }
    const nlohmann::json& milliseconds = document.at("milliseconds");
    for (int i = 0; i < kStageCount; ++i) {
      frame.stage_milliseconds[static_cast<std::size_t>(i)] = milliseconds.at(nameOf(static_cast<Stage>(i)));
    }
    frame.milliseconds = milliseconds.at("total");
    return frame;
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(planes_json.string() + ": cannot be read for the report, " + error.what());
  }
}

}  // namespace line_plane_segmentation
