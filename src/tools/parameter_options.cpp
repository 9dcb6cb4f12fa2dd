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
                        "kinect, short_range or paper")(
      "set", po::value<std::vector<std::string>>()->value_name("PARAMETER=VALUE")->default_value({}, ""),
      "change one parameter of the preset; may be given more than once");
}

Parameters parametersOf(const po::variables_map& given) {
  Parameters parameters;
  const auto& preset = given["preset"].as<std::string>();
  if (!loadPreset(preset, parameters)) {
    throw BadInput("no preset is named '" + preset + "'; there are kinect, short_range and paper");
  }
  for (const std::string& setting : given["set"].as<std::vector<std::string>>()) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw BadInput("--set takes PARAMETER=VALUE, not '" + setting + "'");
    const std::string problem =
        setParameter(setting.substr(0, equals), setting.substr(equals + 1), parameters);
    if (!problem.empty()) throw BadInput(problem);
  }
  const std::vector<std::string> changes = sanitize(parameters);
  if (!changes.empty()) throw BadInput("these settings do not go together: " + changes.front());
  return parameters;
}

std::string parameterList() {
  std::ostringstream text;
  text << std::boolalpha
       << "Parameters (default, smallest to largest; 0 as default: from the image's width)\n";
  const Parameters defaults;
  visitParameters(defaults, [&text](const std::string& name, auto value, auto min, auto max) {
    text << "  " << name << std::string(24 - std::min<std::size_t>(name.size(), 23), ' ');
    if constexpr (std::is_same_v<decltype(value), Method>) {
      text << "adaptive, or paper\n";
    } else {
      text << value << ", " << min << " to " << max << '\n';
    }
  });
  return text.str();
}

}  // namespace line_plane_segmentation
