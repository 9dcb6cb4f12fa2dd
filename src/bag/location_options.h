// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "line_plane_segmentation/ros/location_parameters.h"

namespace line_plane_segmentation {

/// Sets the parameter of this name from text: frames, orientations, tracking, as the nodelet calls them.
/// @return false if there is none of this name
/// @throws BadInput if the value is none for it
bool setLocationParameter(const std::string& name, const std::string& value, LocationParameters& parameters);

/// These parameters, for --help.
std::string locationParameterList();

}  // namespace line_plane_segmentation
