// SPDX-License-Identifier: BSD-3-Clause
// What the README's tables say of parameters is what the nodelet has.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "line_plane_segmentation/ros/parameter_config.h"

namespace line_plane_segmentation {
namespace {

/// The rows "| `name` | default |" of the section about parameters, up to what is set at the start only.
std::map<std::string, std::string> parametersOfReadme() {
  const std::regex row("^\\| `(\\w+)`(, `\\w+`)* \\| ([^|]*) \\|.*");
  std::map<std::string, std::string> defaults;
  std::ifstream readme(README);
  bool is_inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line == "## Parameters") is_inside = true;
    if (line == "Only at the start:") break;
    std::smatch match;
    if (is_inside && std::regex_match(line, match, row)) defaults[match[1]] = match[3];
  }
  return defaults;
}

std::map<std::string, double> numbersOfNodelet() {
  std::map<std::string, double> defaults;
  NodeletParameters parameters;
  visitNodeletParameters(parameters, [&](const char* name, auto& value, auto, auto) {
    defaults[name] = static_cast<double>(value);
  });
  return defaults;
}

TEST(Readme, saysTheDefaults) {
  const std::map<std::string, double> numbers = numbersOfNodelet();
  int compared = 0;
  for (const auto& [name, text] : parametersOfReadme()) {
    if (name == "preset" || name == "target_frame") continue;  // texts
    ASSERT_EQ(1U, numbers.count(name)) << name << " is no parameter";
    const double expected = text == "true" || text == "adaptive" ? 1.0 : std::stod(text);
    EXPECT_DOUBLE_EQ(expected, numbers.at(name)) << name;
    ++compared;
  }
  EXPECT_GE(compared, 18);
}

}  // namespace
}  // namespace line_plane_segmentation
