// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace line_plane_segmentation {

/// How a program ended and what it said.
struct ToolResult {
  int exit_code = -1;  ///< -1 if it ended by a signal
  std::string out;
  std::string err;
};

/// Runs a program and waits for it.
/// @param before  shell commands that set limits for it, ended by ';'
ToolResult runProcess(const std::string& program, const std::vector<std::string>& arguments,
                      const std::string& before = "");

/// Expects what every tool promises on bad input: exit code 1 and one line on stderr, which begins with the
/// tool's name and contains `reason`, and nothing on stdout.
void expectRefusal(const ToolResult& result, const std::string& tool, const std::string& reason);

}  // namespace line_plane_segmentation
