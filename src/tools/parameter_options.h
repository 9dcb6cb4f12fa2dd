// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <string>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Adds --preset and --set.
void addParameterOptions(boost::program_options::options_description& options);

/// The parameters that --preset and --set ask for.
/// @throws BadInput that names what is wrong
Parameters parametersOf(const boost::program_options::variables_map& given);

/// All parameters with default and bounds, for --help.
std::string parameterList();

}  // namespace line_plane_segmentation
