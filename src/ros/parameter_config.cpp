// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_config.h"

#include <dynamic_reconfigure/config_tools.h>
#include <ros/console.h>
#include <ros/node_handle.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "printable_text.h"

namespace line_plane_segmentation {
namespace {

using dynamic_reconfigure::ConfigTools;
using ConfigMessage = dynamic_reconfigure::Config;

// The message form of a config holds the values by name, so no parameter has to be named here.
template <typename T>
void read(const ConfigMessage& message, const std::string& name, T& value) {
  ConfigTools::getParameter(message, name, value);
}

void read(const ConfigMessage& message, const std::string& name, Method& value) {
  int number = static_cast<int>(value);
  read(message, name, number);
  value = static_cast<Method>(number);
}

template <typename T>
void append(ConfigMessage& message, const std::string& name, const T& value) {
  ConfigTools::appendParameter(message, name, value);
}

void append(ConfigMessage& message, const std::string& name, const Method& value) {
  append(message, name, static_cast<int>(value));
}

void refuseNan(const ConfigMessage& current, const std::string& name, double& value,
               std::vector<std::string>& changes) {
  if (!std::isnan(value)) return;
  read(current, name, value);
  changes.push_back(name + " = NaN was refused, it stays " + std::to_string(value));
}

template <typename T>
void refuseNan(const ConfigMessage&, const std::string&, T&, std::vector<std::string>&) {}

template <typename T>
bool getAs(const ros::NodeHandle& nh, const std::string& name, T& value) {
  return nh.getParam(name, value);
}

// A method has a name, as in the tools, or the number that dynamic_reconfigure gives it.
bool getAs(const ros::NodeHandle& nh, const std::string& name, Method& value) {
  std::string method_name;
  if (nh.getParam(name, method_name)) {
    Parameters named;
    if (!setParameter(name, method_name, named).empty()) return false;
    value = named.method;
    return true;
  }
  int number = 0;
  if (!nh.getParam(name, number)) return false;
  value = static_cast<Method>(number);
  return true;
}

template <typename T>
void setAs(const ros::NodeHandle& nh, const std::string& name, const T& value) {
  nh.setParam(name, value);
}

void setAs(const ros::NodeHandle& nh, const std::string& name, const Method& value) {
  nh.setParam(name, static_cast<int>(value));
}

std::string expectedFor(bool) { return "true or false"; }
std::string expectedFor(int) { return "a whole number"; }
std::string expectedFor(double) { return "a number"; }
std::string expectedFor(Method) { return "adaptive or paper"; }

template <typename T>
std::string problemWith(const ros::NodeHandle& nh, const std::string& name, T value, T min, T max) {
  if (!nh.hasParam(name)) return {};
  if (!getAs(nh, name, value)) return "~" + name + " must be " + expectedFor(value) + "; ";
  // A negated range test would accept NaN.
  if (value >= min && value <= max) return {};
  std::ostringstream problem;
  problem << "~" << name << " = " << static_cast<double>(value) << " is not within "
          << static_cast<double>(min) << " to " << static_cast<double>(max) << "; ";
  return problem.str();
}

std::string problemWithText(const ros::NodeHandle& nh, const std::string& name) {
  std::string value;
  return !nh.hasParam(name) || nh.getParam(name, value) ? "" : "~" + name + " must be a text; ";
}

void refuseTooLong(const std::string& name, const std::string& current, std::string& frame,
                   std::vector<std::string>& changes) {
  if (frame.size() <= kLongestFrameName) return;
  changes.push_back(name + " has more than " + std::to_string(kLongestFrameName) + " characters, it stays '" +
                    current + "'");
  frame = current;
}

bool isFallback(const std::string& text) { return text == kNoTransform || text == kLatestTransform; }

void refuseUnknownFallback(const std::string& current, std::string& fallback,
                           std::vector<std::string>& changes) {
  if (isFallback(fallback)) return;
  changes.push_back("tf_fallback = '" + printableText(fallback) + "' was refused, it stays " + current);
  fallback = current;
}

void removeLeadingSlashes(const std::string& name, std::string& frame, std::vector<std::string>& changes) {
  if (frame.empty() || frame.front() != '/') return;
  frame.erase(0, frame.find_first_not_of('/'));
  changes.push_back(name + " starts with a slash, which tf2 refuses: it is cut off");
}

constexpr char kNoPreset[] = "custom";

std::string presetOf(const Parameters& method) {
  for (const char* name : kPresetNames) {
    Parameters preset;
    if (loadPreset(name, preset) && valuesOf(preset) == valuesOf(method)) return name;
  }
  return kNoPreset;
}

// The preset, with the values in which the request differs from the current parameters.
Parameters presetAndChanges(const Parameters& preset, const Parameters& current,
                            const Parameters& requested) {
  ConfigMessage before;
  ConfigMessage after;
  visitParameters(current,
                  [&](const char* name, const auto& value, auto, auto) { append(before, name, value); });
  visitParameters(requested,
                  [&](const char* name, const auto& value, auto, auto) { append(after, name, value); });
  Parameters parameters = preset;
  visitParameters(parameters, [&](const char* name, auto& value, auto, auto) {
    auto old_value = value;
    auto new_value = value;
    read(before, name, old_value);
    read(after, name, new_value);
    if (!(new_value == old_value)) value = new_value;
  });
  return parameters;
}

void applyPreset(const NodeletParameters& current, NodeletParameters& requested,
                 std::vector<std::string>& changes) {
  Parameters preset;
  if (requested.preset == current.preset || requested.preset == kNoPreset) return;
  if (loadPreset(requested.preset, preset)) {
    requested.method = presetAndChanges(preset, current.method, requested.method);
  } else {
    changes.push_back("no preset is named '" + printableText(requested.preset) + "'");
  }
}

}  // namespace

NodeletParameters parametersFrom(const PlaneSegmenterConfig& config) {
  ConfigMessage message;
  config.__toMessage__(message);
  NodeletParameters parameters;
  visitNodeletParameters(parameters,
                         [&](const char* name, auto& value, auto, auto) { read(message, name, value); });
  visitTexts(parameters, [&](const char* name, std::string& text) { read(message, name, text); });
  read(message, "preset", parameters.preset);
  return parameters;
}

void writeParameters(const NodeletParameters& parameters, PlaneSegmenterConfig& config) {
  ConfigMessage message;
  visitNodeletParameters(
      parameters, [&](const char* name, const auto& value, auto, auto) { append(message, name, value); });
  visitTexts(parameters, [&](const char* name, const std::string& text) { append(message, name, text); });
  append(message, "preset", parameters.preset);
  config.__fromMessage__(message);
}

NodeletParameters reconfigured(const NodeletParameters& current, PlaneSegmenterConfig& config,
                               std::vector<std::string>& changes) {
  ConfigMessage current_message;
  visitNodeletParameters(current, [&](const char* name, const auto& value, auto, auto) {
    append(current_message, name, value);
  });

  NodeletParameters parameters = parametersFrom(config);
  visitNodeletParameters(parameters, [&](const char* name, auto& value, auto, auto) {
    refuseNan(current_message, name, value, changes);
  });
  visitFrames(parameters, [&](const char* name, std::string& frame) {
    std::string before;
    visitFrames(current, [&](const std::string& other, const std::string& value) {
      if (other == name) before = value;
    });
    refuseTooLong(name, before, frame, changes);
    removeLeadingSlashes(name, frame, changes);
  });
  refuseUnknownFallback(current.location.frames.tf_fallback, parameters.location.frames.tf_fallback, changes);
  if (parameters.method.method == current.method.method) {
    const std::vector<std::string> unused = changesWithoutEffect(current.method, parameters.method);
    changes.insert(changes.end(), unused.begin(), unused.end());
  }
  applyPreset(current, parameters, changes);
  const std::vector<std::string> fixed = sanitize(parameters.method);
  changes.insert(changes.end(), fixed.begin(), fixed.end());
  parameters.preset = presetOf(parameters.method);
  writeParameters(parameters, config);
  return parameters;
}

void checkParameterServer(const ros::NodeHandle& private_nh) {
  std::string problems;
  NodeletParameters parameters;
  visitNodeletParameters(parameters, [&](const char* name, auto& value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    problems += problemWith(private_nh, name, value, static_cast<T>(min), static_cast<T>(max));
  });
  visitTexts(parameters,
             [&](const char* name, std::string&) { problems += problemWithText(private_nh, name); });
  if (!isFallback(private_nh.param<std::string>("tf_fallback", kNoTransform))) {
    problems += "~tf_fallback must be none or latest; ";
  }
  if (private_nh.hasParam("fine_spacing"))
    ROS_WARN("%s", setParameter("fine_spacing", "0", parameters.method).c_str());
  problems += problemWithText(private_nh, "preset");
  const std::string preset = private_nh.param<std::string>("preset", kPresetNames[0]);
  if (preset != kNoPreset && !loadPreset(preset, parameters.method)) {
    problems += "~preset = '" + printableText(preset) + "' is none of " + presetNames() + ", custom; ";
  }
  if (!problems.empty()) throw std::invalid_argument(problems + "correct them and start again");
}

std::string expandPreset(const ros::NodeHandle& private_nh) {
  // dynamic_reconfigure reads a number alone.
  Method method{};
  if (private_nh.hasParam("method") && getAs(private_nh, "method", method)) {
    setAs(private_nh, "method", method);
  }
  std::string name = private_nh.param<std::string>("preset", kPresetNames[0]);
  Parameters preset;
  if (name == kPresetNames[0] || !loadPreset(name, preset)) return name;
  visitParameters(preset, [&](const char* parameter, const auto& value, auto, auto) {
    if (!private_nh.hasParam(parameter)) setAs(private_nh, parameter, value);
  });
  return name;
}

}  // namespace line_plane_segmentation
