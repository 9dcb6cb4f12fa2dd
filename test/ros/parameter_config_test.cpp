// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/ros/parameter_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <type_traits>

namespace line_plane_segmentation {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Values = std::map<std::string, double>;

template <typename Parameter>
void collect(const std::vector<Parameter>& parameters, Values& values) {
  for (const Parameter& parameter : parameters) values[parameter.name] = static_cast<double>(parameter.value);
}

Values valuesOf(const dynamic_reconfigure::Config& config) {
  Values values;
  collect(config.bools, values);
  collect(config.ints, values);
  collect(config.doubles, values);
  return values;
}

template <typename T>
constexpr const char* typeNameOf() {
  return std::is_same<T, bool>::value ? "bool" : std::is_same<T, double>::value ? "double" : "int";
}

// Every value is another one than its default, and sanitize() has nothing to say about it.
Parameters unusualParameters() {
  Parameters parameters;
  visitParameters(parameters, [](const char*, auto& value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    value = static_cast<T>(value == static_cast<T>(max) ? min : max);
  });
  parameters.scanlines.min_range = 0.2;
  return parameters;
}

// The .cfg file repeats what parameters.h says, because dynamic_reconfigure cannot read that.
TEST(ConfigFile, agreesWithTheParameters) {
  const auto& description = PlaneSegmenterConfig::__getDescriptionMessage__();
  const Values defaults = valuesOf(description.dflt);
  const Values minima = valuesOf(description.min);
  const Values maxima = valuesOf(description.max);
  std::map<std::string, std::string> types;
  for (const auto& parameter : PlaneSegmenterConfig::__getParamDescriptions__()) {
    types[parameter->name] = parameter->type;
  }

  Parameters parameters;
  std::size_t count = 0;
  visitParameters(parameters, [&](const char* name, auto& value, auto min, auto max) {
    ++count;
    ASSERT_EQ(1U, defaults.count(name)) << name << " is missing in cfg/PlaneSegmenter.cfg";
    EXPECT_EQ(static_cast<double>(value), defaults.at(name)) << "default of " << name;
    EXPECT_EQ(static_cast<double>(min), minima.at(name)) << "minimum of " << name;
    EXPECT_EQ(static_cast<double>(max), maxima.at(name)) << "maximum of " << name;
    EXPECT_EQ(typeNameOf<std::decay_t<decltype(value)>>(), types.at(name)) << "type of " << name;
  });
  EXPECT_EQ(count, defaults.size()) << "cfg/PlaneSegmenter.cfg has parameters that nothing reads";
}

TEST(ConfigFile, saysUnitAndEffectOfEachParameter) {
  for (const auto& parameter : PlaneSegmenterConfig::__getParamDescriptions__()) {
    EXPECT_EQ('[', parameter->description.front()) << parameter->name;
    if (parameter->type == "double" || (parameter->type == "int" && parameter->name != "method")) {
      EXPECT_NE(std::string::npos, parameter->description.find("Higher ->")) << parameter->name;
    }
  }
}

TEST(ParameterConfig, carriesEveryParameterBothWays) {
  const Parameters unusual = unusualParameters();
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  writeParameters(unusual, config);
  Parameters read = parametersFrom(config);

  std::vector<double> expected;
  visitParameters(unusual, [&](const char*, const auto& value, auto, auto) {
    expected.push_back(static_cast<double>(value));
  });
  std::size_t index = 0;
  visitParameters(read, [&](const char* name, auto& value, auto, auto) {
    EXPECT_EQ(expected[index++], static_cast<double>(value)) << name;
  });
}

// Row 31: the generated clamp lets a NaN through.
TEST(Reconfiguring, refusesEachNanAndTakesTheRest) {
  Parameters current;
  current.extraction.plane_distance = 0.05;
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  config.plane_distance = kNan;
  config.max_range = 5.0;
  config.__clamp__();
  ASSERT_TRUE(std::isnan(config.plane_distance));

  std::vector<std::string> changes;
  const Parameters parameters = reconfigured(current, config, changes);

  EXPECT_EQ(0.05, parameters.extraction.plane_distance);
  EXPECT_EQ(0.05, config.plane_distance) << "the client is not told";
  EXPECT_EQ(5.0, parameters.scanlines.max_range);
  ASSERT_EQ(1U, changes.size());
  EXPECT_NE(std::string::npos, changes.front().find("plane_distance"));
}

TEST(Reconfiguring, refusesNanInEveryField) {
  for (const auto& description : PlaneSegmenterConfig::__getParamDescriptions__()) {
    if (description->type != "double") continue;
    dynamic_reconfigure::Config message;
    dynamic_reconfigure::ConfigTools::appendParameter(message, description->name, kNan);
    PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
    config.__fromMessage__(message);
    std::vector<std::string> changes;
    reconfigured(Parameters{}, config, changes);
    boost::any value;
    boost::any expected;
    description->getValue(config, value);
    description->getValue(PlaneSegmenterConfig::__getDefault__(), expected);
    EXPECT_EQ(boost::any_cast<double>(expected), boost::any_cast<double>(value)) << description->name;
    EXPECT_EQ(1U, changes.size()) << description->name;
  }
}

TEST(Reconfiguring, tellsWhatItPutInOrder) {
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  config.points_per_segment = 4;
  config.min_range = 6.0;
  config.max_range = 2.0;
  std::vector<std::string> changes;
  const Parameters parameters = reconfigured(Parameters{}, config, changes);
  EXPECT_EQ(2U, changes.size());
  EXPECT_LT(parameters.scanlines.min_range, parameters.scanlines.max_range);
  EXPECT_EQ(parameters.scanlines.min_range, config.min_range);
  EXPECT_EQ(parameters.scanlines.max_range, config.max_range);
  EXPECT_EQ(parameters.candidates.points_per_segment, config.points_per_segment);
  EXPECT_EQ(1, config.points_per_segment % 2);
}

}  // namespace
}  // namespace line_plane_segmentation
