// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_options.h"

#include <algorithm>
#include <sstream>
#include <type_traits>
#include <vector>

#include "run_tool.h"

namespace line_plane_segmentation {

namespace po = boost::program_options;

void addParameterOptions(po::options_description& options) {
  options.add_options()("preset", po::value<std::string>()->value_name("NAME")->default_value("kinect"),
                        presetNames().c_str())(
      "set", po::value<std::vector<std::string>>()->value_name("PARAMETER=VALUE")->default_value({}, ""),
      "change one parameter of the preset; may be given more than once");
}

Parameters parametersOf(const po::variables_map& given, const OtherParameters& set_other) {
  Parameters parameters;
  const auto& preset = given["preset"].as<std::string>();
  if (!loadPreset(preset, parameters)) {
    throw BadInput("no preset is named '" + preset + "'; there are " + presetNames());
  }
  for (const std::string& setting : given["set"].as<std::vector<std::string>>()) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw BadInput("--set takes PARAMETER=VALUE, not '" + setting + "'");
    const std::string name = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (set_other && set_other(name, value)) continue;
    const std::string problem = setParameter(name, value, parameters);
    if (!problem.empty()) throw BadInput(problem);
  }
  for (const std::string& setting : given["set"].as<std::vector<std::string>>()) {
    const std::string name = setting.substr(0, setting.find('='));
    const std::string no_effect = noEffect(name, parameters.method);
    if (!no_effect.empty()) throw BadInput(no_effect);
  }
  const std::vector<std::string> changes = sanitize(parameters);
  if (!changes.empty()) throw BadInput("these settings do not go together: " + changes.front());
  return parameters;
}

std::string parameterLine(const std::string& name, const std::string& value, const std::string& bounds) {
  return "  " + name + std::string(24 - std::min<std::size_t>(name.size(), 23), ' ') + value + ", " + bounds +
         "\n";
}

std::string parameterList() {
  std::string list = "Parameters (default, smallest to largest; 0 as default: from the image's width)\n";
  const auto to_text = [](auto value) {
    std::ostringstream text;
    text << std::boolalpha << value;
    return text.str();
  };
  const Parameters defaults;
  visitParameters(defaults, [&](const std::string& name, auto value, [[maybe_unused]] auto min,
                                [[maybe_unused]] auto max) {
    if constexpr (std::is_same_v<decltype(value), Method>) {
      list += parameterLine(name, "adaptive", "or paper");
    } else {
      list += parameterLine(name, to_text(value), to_text(min) + " to " + to_text(max));
    }
  });
  return list;
}

}  // namespace line_plane_segmentation
