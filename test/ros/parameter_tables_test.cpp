// SPDX-License-Identifier: BSD-3-Clause
// The defaults in the parameter tables of README.md and doc/ros.md are those of the nodelet.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include "parameter_config.h"
#include "start_parameters.h"

namespace line_plane_segmentation {
namespace {

/// Default per parameter of the rows "| `name` | default | ..." of the sections about parameters that can be
/// changed at run time. A row may hold several names: "| `name`, `name` | default | ...".
std::map<std::string, std::string> parameterTable(const std::string& file) {
  const std::regex row("^\\| (`\\w+`(?:, `\\w+`)*) \\| ([^|]*) \\|.*");
  const std::regex name("\\w+");
  std::map<std::string, std::string> defaults;
  std::ifstream document(std::string(SOURCE_FOLDER) + "/" + file);
  bool is_inside = false;
  for (std::string line; std::getline(document, line);) {
    if (!line.empty() && line.front() == '#') {
      is_inside = line == "## Parameters" || line == "### Parameters of single stages";
    }
    std::smatch match;
    if (!is_inside || !std::regex_match(line, match, row)) continue;
    const std::string names = match[1];
    for (auto i = std::sregex_iterator(names.begin(), names.end(), name); i != std::sregex_iterator(); ++i) {
      defaults[i->str()] = match[2];
    }
  }
  return defaults;
}

std::map<std::string, double> numericDefaults() {
  std::map<std::string, double> defaults;
  NodeletParameters parameters;
  visitNodeletParameters(parameters, [&](const char* name, auto& value, auto, auto) {
    defaults[name] = static_cast<double>(value);
  });
  return defaults;
}

void expectDefaults(const std::string& file, std::size_t least_count) {
  const std::map<std::string, double> numbers = numericDefaults();
  const std::map<std::string, std::string> texts{{"preset", NodeletParameters().preset},
                                                 {"target_frame", "none"},
                                                 {"gravity_frame", "none"},
                                                 {"fixed_frame", "none"},
                                                 {"tf_fallback", FrameParameters().tf_fallback}};
  const std::map<std::string, std::string> table = parameterTable(file);
  EXPECT_GE(table.size(), least_count);
  for (const auto& [name, text] : table) {
    if (texts.count(name) != 0) {
      EXPECT_EQ(texts.at(name), text) << name;
      continue;
    }
    ASSERT_EQ(1U, numbers.count(name)) << name << " is not a parameter";
    const bool is_one = text == "true" || text == "adaptive", is_zero = text == "false";
    const double expected = is_one ? 1.0 : is_zero ? 0.0 : std::stod(text);
    EXPECT_DOUBLE_EQ(expected, numbers.at(name)) << name;
  }
}

// Those that count only at the start have no list of defaults: that each is there.
TEST(ParameterTables, rosReferenceListsTheStartParameters) {
  std::ifstream document(std::string(SOURCE_FOLDER) + "/doc/ros.md");
  const std::string text((std::istreambuf_iterator<char>(document)), std::istreambuf_iterator<char>());
  for (const std::string& name : startParameterNames()) {
    EXPECT_NE(std::string::npos, text.find("\n| `" + name + "` | ", text.find("### At start only"))) << name;
  }
}

TEST(ParameterTables, readmeStatesTheDefaults) { expectDefaults("README.md", 5); }

TEST(ParameterTables, rosReferenceListsAllParameters) {
  const std::map<std::string, std::string> table = parameterTable("doc/ros.md");
  for (const auto& [name, value] : numericDefaults()) {
    EXPECT_EQ(1U, table.count(name)) << name << " = " << value << " is missing in doc/ros.md";
  }
}

TEST(ParameterTables, rosReferenceStatesTheDefaults) { expectDefaults("doc/ros.md", 27); }

}  // namespace
}  // namespace line_plane_segmentation
