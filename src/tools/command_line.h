// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <string>

namespace line_plane_segmentation {

/// Reads a command line. Options must be written out in full, so that a new option never changes the meaning
/// of an old command.
/// @throws boost::program_options::error on an unknown option or a value of the wrong type
boost::program_options::variables_map parseOptions(
    int argc, char** argv, const boost::program_options::options_description& options,
    const boost::program_options::positional_options_description& positional);

/// Returns the value of a required option.
/// @throws BadInput if it was not given
const boost::program_options::variable_value& required(const boost::program_options::variables_map& given,
                                                       const std::string& option);

}  // namespace line_plane_segmentation
