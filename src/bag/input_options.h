// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bag_task.h"

namespace line_plane_segmentation {

/// Sets one of the parameters that the nodelet has at its start only: depth_unit, info_matching, max_pixels,
/// rectify.
/// @return false if there is none of this name
/// @throws BadInput if the value is not one for it
bool setInputParameter(const std::string& name, const std::string& value, BagTask& task);

/// Returns these parameters, for --help.
std::string inputParameterList();

}  // namespace line_plane_segmentation
