// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneSegmenterConfig.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// The method's parameters in a dynamic_reconfigure config, matched by name.
Parameters parametersFrom(const PlaneSegmenterConfig& config);

/// Writes the parameters into the config, matched by name.
void writeParameters(const Parameters& parameters, PlaneSegmenterConfig& config);

/// What a reconfigure request makes of the current parameters: a NaN is refused and leaves its parameter
/// as it is, everything else is put in order by sanitize(). `config` is made to tell the outcome.
/// @param changes  gets one line for each value that was refused or changed
Parameters reconfigured(const Parameters& current, PlaneSegmenterConfig& config,
                        std::vector<std::string>& changes);

/// Looks at the parameters that somebody set for this node handle before it started.
/// @throw std::invalid_argument that names each one of the wrong type or outside its bounds
void checkParameterServer(const ros::NodeHandle& private_nh);

}  // namespace line_plane_segmentation
