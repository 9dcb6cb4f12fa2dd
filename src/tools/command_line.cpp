// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "run_tool.h"

namespace line_plane_segmentation {

namespace po = boost::program_options;

po::variables_map parseOptions(int argc, char** argv, const po::options_description& options,
                               const po::positional_options_description& positional) {
  namespace style = po::command_line_style;
  const int full_names = style::unix_style & ~style::allow_guessing;
  po::variables_map given;
  po::store(
      po::command_line_parser(argc, argv).options(options).positional(positional).style(full_names).run(),
      given);
  po::notify(given);
  return given;
}

const po::variable_value& required(const po::variables_map& given, const std::string& option) {
  if (given.count(option) == 0) throw BadInput("--" + option + " is missing; see --help");
  return given[option];
}

}  // namespace line_plane_segmentation
