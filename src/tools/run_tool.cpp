// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace line_plane_segmentation {

int runTool(const std::string& name, const std::function<void()>& tool) {
  try {
    tool();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::string message = error.what();
    while (!message.empty() && message.back() == '\n') message.pop_back();
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::cerr << name << ": " << message << '\n';
    return EXIT_FAILURE;
  }
}

}  // namespace line_plane_segmentation
