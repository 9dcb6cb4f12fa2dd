// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace line_plane_segmentation {

/// Converts a path for the report program: a list of bytes, because JSON must be UTF-8 and a path need not
/// be.
nlohmann::json pathForReport(const std::filesystem::path& path);

/// Runs the Python program that makes pages, plots and tables: the folder `report` beside the running
/// program.
/// @param kind  of report, such as "html"; report/__main__.py lists the kinds
/// @param data  content of the report
/// @return the file's content
/// @throws BadInput if the program or one of its Python modules is missing, or it fails
std::string makeReport(const std::string& kind, const nlohmann::json& data);

}  // namespace line_plane_segmentation
