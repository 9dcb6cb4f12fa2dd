// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Inputs of one target, by the names of their files.
using Seeds = std::map<std::string, std::vector<std::uint8_t>>;

/// What each target's corpus starts from, by the target's name: every row of validationCases() and
/// cloudCases(), and some good messages and parameters with changes.
std::map<std::string, Seeds> seeds();

/// The file's name for a row of these tables.
std::string seedNameOf(std::string row);

}  // namespace line_plane_segmentation
