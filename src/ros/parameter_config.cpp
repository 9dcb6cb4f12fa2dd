// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/ros/parameter_config.h"

#include <dynamic_reconfigure/config_tools.h>
#include <ros/node_handle.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace line_plane_segmentation {
namespace {

using dynamic_reconfigure::ConfigTools;
using ConfigMessage = dynamic_reconfigure::Config;

// The message form of a config has its values by name, so that no parameter has to be named here.
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

void keepIfNan(const ConfigMessage& current, const std::string& name, double& value,
               std::vector<std::string>& changes) {
  if (!std::isnan(value)) return;
  read(current, name, value);
  changes.push_back(name + " = NaN was refused, it stays " + std::to_string(value));
}

template <typename T>
void keepIfNan(const ConfigMessage&, const std::string&, T&, std::vector<std::string>&) {}

template <typename T>
bool getAs(const ros::NodeHandle& nh, const std::string& name, T& value) {
  return nh.getParam(name, value);
}

bool getAs(const ros::NodeHandle& nh, const std::string& name, Method& value) {
  int number = 0;
  if (!nh.getParam(name, number)) return false;
  value = static_cast<Method>(number);
  return true;
}

template <typename T>
std::string problemWith(const ros::NodeHandle& nh, const std::string& name, T value, T min, T max) {
  if (!nh.hasParam(name)) return {};
  if (!getAs(nh, name, value)) return "~" + name + " has the wrong type; ";
  // Not "outside", which a NaN is not.
  if (value >= min && value <= max) return {};
  std::ostringstream problem;
  problem << "~" << name << " = " << static_cast<double>(value) << " is not within "
          << static_cast<double>(min) << " to " << static_cast<double>(max) << "; ";
  return problem.str();
}

}  // namespace

Parameters parametersFrom(const PlaneSegmenterConfig& config) {
  ConfigMessage message;
  config.__toMessage__(message);
  Parameters parameters;
  visitParameters(parameters, [&](const char* name, auto& value, auto, auto) { read(message, name, value); });
  return parameters;
}

void writeParameters(const Parameters& parameters, PlaneSegmenterConfig& config) {
  ConfigMessage message;
  visitParameters(parameters,
                  [&](const char* name, const auto& value, auto, auto) { append(message, name, value); });
  config.__fromMessage__(message);
}

Parameters reconfigured(const Parameters& current, PlaneSegmenterConfig& config,
                        std::vector<std::string>& changes) {
  ConfigMessage current_message;
  visitParameters(current, [&](const char* name, const auto& value, auto, auto) {
    append(current_message, name, value);
  });

  Parameters parameters = parametersFrom(config);
  visitParameters(parameters, [&](const char* name, auto& value, auto, auto) {
    keepIfNan(current_message, name, value, changes);
  });
  const std::vector<std::string> fixed = sanitize(parameters);
  changes.insert(changes.end(), fixed.begin(), fixed.end());
  writeParameters(parameters, config);
  return parameters;
}

void checkParameterServer(const ros::NodeHandle& private_nh) {
  std::string problems;
  Parameters parameters;
  visitParameters(parameters, [&](const char* name, auto& value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    problems += problemWith(private_nh, name, value, static_cast<T>(min), static_cast<T>(max));
  });
  if (!problems.empty()) throw std::invalid_argument(problems + "correct them and start again");
}

}  // namespace line_plane_segmentation
