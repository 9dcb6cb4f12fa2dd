// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "location_parameters.h"

namespace line_plane_segmentation {

/// Sets a parameter of frames, orientation or tracking from text. Names are those of the nodelet.
/// @return false if there is no such parameter
/// @throws BadInput if the value is invalid
bool setLocationParameter(const std::string& name, const std::string& value, LocationParameters& parameters);

/// Returns the list of these parameters for --help.
std::string locationParameterList();

}  // namespace line_plane_segmentation
