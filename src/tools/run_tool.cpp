// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>

namespace line_plane_segmentation {
namespace {

// Output is buffered: a full disk may only show here.
void flushStandardOutput() {
  errno = 0;
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0 && std::cout.good() && std::ferror(stdout) == 0;
  if (flushed) return;
  throw BadInput("standard output cannot be written" +
                 (errno == 0 ? "" : std::string(", ") + std::strerror(errno)));
}

}  // namespace

int runTool(const std::string& name, const std::function<void()>& tool) {
  try {
    tool();
    flushStandardOutput();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::string message = error.what();
    while (!message.empty() && message.back() == '\n') message.pop_back();
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::cerr << name << ": " << message << '\n';
    return EXIT_FAILURE;
  }
}

int runTool(const std::string& name, int argc, char** argv, const std::function<void(int, char**)>& tool) {
  return runTool(name, [&] {
    const auto is_version = [](const char* argument) { return std::strcmp(argument, "--version") == 0; };
    if (std::any_of(argv + 1, argv + argc, is_version)) {
      std::cout << name << " " << LPS_VERSION << '\n';
      return;
    }
    tool(argc, argv);
  });
}

}  // namespace line_plane_segmentation
