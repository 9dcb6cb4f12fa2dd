// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Adds --preset and --set.
void addParameterOptions(boost::program_options::options_description& options);

/// Sets a parameter that is none of the method's own.
/// @return false if it knows none of this name
/// @throws BadInput if the value is none for it
using OtherParameters = std::function<bool(const std::string& name, const std::string& value)>;

/// The parameters that --preset and --set ask for.
/// @param setOther  is asked first
/// @throws BadInput that names what is wrong
Parameters parametersOf(const boost::program_options::variables_map& given,
                        const OtherParameters& setOther = {});

/// All parameters with default and bounds, for --help.
std::string parameterList();

/// A line of such a list.
std::string parameterLine(const std::string& name, const std::string& value, const std::string& bounds);

}  // namespace line_plane_segmentation
