// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace line_plane_segmentation {

/// Invalid input of the user. The message is one line that names the problem and, where possible, the remedy.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a command-line tool: the body of its main().
/// @return 0 if `tool` returned; 1, and one line on stderr that begins with `name`, if it threw
int runTool(const std::string& name, const std::function<void()>& tool);

/// The same for a tool that reads its command line. Prints the package's version, and does nothing else, if
/// `--version` is among the arguments.
int runTool(const std::string& name, int argc, char** argv, const std::function<void(int, char**)>& tool);

}  // namespace line_plane_segmentation
