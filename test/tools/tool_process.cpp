// SPDX-License-Identifier: BSD-3-Clause
#include "tool_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>

#include "temporary_folder.h"

namespace line_plane_segmentation {
namespace {

std::string quoted(const std::string& text) {
  return "'" + boost::replace_all_copy(text, "'", "'\\''") + "'";
}

}  // namespace

ToolResult runProcess(const std::string& program, const std::vector<std::string>& arguments,
                      const std::string& before) {
  const TemporaryFolder folder;
  std::string command = before + quoted(program);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " >" + quoted((folder / "out").string()) + " 2>" + quoted((folder / "err").string());
  const int status = std::system(command.c_str());

  ToolResult result;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  result.out = textOf(folder / "out");
  result.err = textOf(folder / "err");
  return result;
}

void expectRefusal(const ToolResult& result, const std::string& tool, const std::string& reason) {
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(result.err.rfind(tool + ": ", 0), 0U) << result.err;
  EXPECT_NE(result.err.find(reason), std::string::npos) << "expected '" << reason << "' in: " << result.err;
  EXPECT_EQ(result.out, "");
}

}  // namespace line_plane_segmentation
