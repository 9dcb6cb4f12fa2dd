// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bag_task.h"

namespace line_plane_segmentation {

/// Sets a start parameter of the nodelet: depth_unit, info_matching, max_pixels or rectify.
/// @return false if there is no such parameter
/// @throws BadInput if the value is invalid
bool setInputParameter(const std::string& name, const std::string& value, BagTask& task);

/// Returns the list of these parameters for --help.
std::string inputParameterList();

}  // namespace line_plane_segmentation
