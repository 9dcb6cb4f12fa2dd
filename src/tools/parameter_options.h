// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Adds --preset and --set.
void addParameterOptions(boost::program_options::options_description& options);

/// Sets a parameter that does not belong to the method.
/// @return false if there is no such parameter
/// @throws BadInput if the value is invalid
using OtherParameters = std::function<bool(const std::string& name, const std::string& value)>;

/// Returns the parameters that --preset and --set select.
/// @param set_other  called first for each --set
/// @throws BadInput if a name or value is invalid
Parameters parametersOf(const boost::program_options::variables_map& given,
                        const OtherParameters& set_other = {});

/// Lists all parameters with default and bounds, for --help.
std::string parameterList();

/// Formats a line of such a list.
std::string parameterLine(const std::string& name, const std::string& value, const std::string& bounds);

}  // namespace line_plane_segmentation
