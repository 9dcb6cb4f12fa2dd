// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

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

// Every value differs from its default and is accepted by sanitize().
NodeletParameters unusualParameters() {
  NodeletParameters parameters;
  visitNodeletParameters(parameters, [](const char*, auto& value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    value = static_cast<T>(value == static_cast<T>(max) ? min : max);
  });
  visitFrames(parameters, [](const char* name, std::string& frame) { frame = std::string("my_") + name; });
  parameters.location.frames.tf_fallback = kLatestTransform;
  parameters.method.scanlines.min_range = 0.2;
  parameters.preset = "custom";
  return parameters;
}

TEST(ConfigFile, groupsAllButWhatChoosesTheRest) {
  std::size_t groups = 0, in_groups = 0;
  std::vector<std::string> above;
  for (const dynamic_reconfigure::Group& group : PlaneSegmenterConfig::__getDescriptionMessage__().groups) {
    if (group.name == "Default") {
      for (const auto& parameter : group.parameters) above.push_back(parameter.name);
      continue;
    }
    ++groups;
    in_groups += group.parameters.size();
  }
  EXPECT_EQ((std::vector<std::string>{"preset", "method"}), above);
  EXPECT_GE(groups, 5U);
  EXPECT_EQ(in_groups + above.size(), PlaneSegmenterConfig::__getParamDescriptions__().size());
}

// The .cfg file repeats the values of parameters.h, which dynamic_reconfigure cannot read.
TEST(ConfigFile, agreesWithTheParameters) {
  const auto& description = PlaneSegmenterConfig::__getDescriptionMessage__();
  const Values defaults = valuesOf(description.dflt);
  const Values minima = valuesOf(description.min);
  const Values maxima = valuesOf(description.max);
  std::map<std::string, std::string> types;
  for (const auto& parameter : PlaneSegmenterConfig::__getParamDescriptions__()) {
    types[parameter->name] = parameter->type;
  }

  NodeletParameters parameters;
  std::size_t count = 0;
  visitNodeletParameters(parameters, [&](const char* name, auto& value, auto min, auto max) {
    ++count;
    ASSERT_EQ(1U, defaults.count(name)) << name << " is missing in cfg/PlaneSegmenter.cfg";
    EXPECT_EQ(static_cast<double>(value), defaults.at(name)) << "default of " << name;
    EXPECT_EQ(static_cast<double>(min), minima.at(name)) << "minimum of " << name;
    EXPECT_EQ(static_cast<double>(max), maxima.at(name)) << "maximum of " << name;
    EXPECT_EQ(typeNameOf<std::decay_t<decltype(value)>>(), types.at(name)) << "type of " << name;
  });
  EXPECT_EQ(count, defaults.size()) << "cfg/PlaneSegmenter.cfg has parameters that nothing reads";

  std::map<std::string, std::string> texts{{"preset", parameters.preset}};
  visitTexts(parameters, [&](const char* name, const std::string& text) { texts[name] = text; });
  std::map<std::string, std::string> default_texts;
  for (const auto& text : description.dflt.strs) default_texts[text.name] = text.value;
  EXPECT_EQ(texts, default_texts);
}

TEST(ConfigFile, saysUnitAndEffectOfEachParameter) {
  for (const auto& parameter : PlaneSegmenterConfig::__getParamDescriptions__()) {
    EXPECT_EQ('[', parameter->description.front()) << parameter->name;
    if (parameter->type == "double" || (parameter->type == "int" && parameter->name != "method")) {
      for (const char* effect : {". Increase to ", "; decrease to "}) {
        EXPECT_NE(std::string::npos, parameter->description.find(effect)) << parameter->name << effect;
      }
    }
  }
}

TEST(ParameterConfig, carriesEveryParameterBothWays) {
  const NodeletParameters unusual = unusualParameters();
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  writeParameters(unusual, config);
  NodeletParameters read = parametersFrom(config);

  std::vector<double> expected;
  visitNodeletParameters(unusual, [&](const char*, const auto& value, auto, auto) {
    expected.push_back(static_cast<double>(value));
  });
  std::size_t index = 0;
  visitNodeletParameters(read, [&](const char* name, auto& value, auto, auto) {
    EXPECT_EQ(expected[index++], static_cast<double>(value)) << name;
  });
  visitFrames(read, [](const std::string& name, std::string& frame) { EXPECT_EQ("my_" + name, frame); });
  EXPECT_EQ(kLatestTransform, read.location.frames.tf_fallback);
  EXPECT_EQ("custom", read.preset);
}

TEST(Reconfiguring, refusesTextsThatAreNone) {
  NodeletParameters current;
  current.location.frames.target_frame = "base_link";
  current.location.frames.tf_fallback = kLatestTransform;
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  config.tf_fallback = std::string(1000000, 'x');
  config.target_frame = std::string(1000000, 'y');
  config.preset = std::string(1000000, 'z');
  std::vector<std::string> changes;
  const NodeletParameters read = reconfigured(current, config, changes);
  EXPECT_EQ("base_link", read.location.frames.target_frame);
  EXPECT_EQ(kLatestTransform, read.location.frames.tf_fallback);
  EXPECT_EQ(kLatestTransform, config.tf_fallback);
  ASSERT_EQ(3U, changes.size());
  for (const std::string& change : changes) EXPECT_LT(change.size(), 400U);
}

// Row 31: the generated clamp does not catch NaN.
TEST(Reconfiguring, refusesEachNanAndTakesTheRest) {
  NodeletParameters current;
  current.method.extraction.plane_distance = 0.05;
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  config.plane_distance = kNan;
  config.max_range = 5.0;
  config.tf_patience = kNan;
  config.__clamp__();
  ASSERT_TRUE(std::isnan(config.plane_distance));

  std::vector<std::string> changes;
  const NodeletParameters parameters = reconfigured(current, config, changes);

  EXPECT_EQ(0.05, parameters.method.extraction.plane_distance);
  EXPECT_EQ(0.05, config.plane_distance) << "the client is not told";
  EXPECT_EQ(5.0, parameters.method.scanlines.max_range);
  EXPECT_EQ(FrameParameters{}.tf_patience, parameters.location.frames.tf_patience);
  ASSERT_EQ(2U, changes.size());
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
    reconfigured(NodeletParameters{}, config, changes);
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
  const Parameters parameters = reconfigured(NodeletParameters{}, config, changes).method;
  ASSERT_EQ(3U, changes.size());
  EXPECT_EQ("points_per_segment has no effect on the method adaptive", changes.front());
  EXPECT_LT(parameters.scanlines.min_range, parameters.scanlines.max_range);
  EXPECT_EQ(parameters.scanlines.min_range, config.min_range);
  EXPECT_EQ(parameters.scanlines.max_range, config.max_range);
  EXPECT_EQ(parameters.candidates.points_per_segment, config.points_per_segment);
  EXPECT_EQ(1, config.points_per_segment % 2);
}

TEST(Reconfiguring, warnsOnlyOfWhatTheMethodDoesNotUse) {
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  config.merge_cost = 5.0;
  std::vector<std::string> changes;
  NodeletParameters paper;
  paper.method.method = Method::kPaper;
  reconfigured(NodeletParameters{}, config, changes);
  EXPECT_TRUE(changes.empty());
  config.method = static_cast<int>(Method::kPaper);
  reconfigured(paper, config, changes);
  ASSERT_EQ(1U, changes.size());
  EXPECT_EQ("merge_cost has no effect on the method paper", changes.front());
}

TEST(Reconfiguring, cutsSlashesOffFrames) {
  for (const char* frame : {"/base_link", "//base_link"}) {
    PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
    config.target_frame = frame;
    std::vector<std::string> changes;
    EXPECT_EQ("base_link", reconfigured({}, config, changes).location.frames.target_frame);
    EXPECT_EQ("base_link", config.target_frame);
    ASSERT_EQ(1U, changes.size());
    EXPECT_NE(std::string::npos, changes.front().find("target_frame"));
  }
}

class Presets : public testing::Test {
 protected:
  void request() { current_ = reconfigured(current_, config_, changes_); }

  NodeletParameters current_;
  PlaneSegmenterConfig config_ = PlaneSegmenterConfig::__getDefault__();
  std::vector<std::string> changes_;
};

TEST_F(Presets, areLoadedWhileItRunsAndReportedBack) {
  for (const char* name : {"paper", "stereo", "stereo_short", "tof", "short_range", "kinect", "paper"}) {
    config_.preset = name;
    request();
    Parameters preset;
    ASSERT_TRUE(loadPreset(name, preset));
    EXPECT_EQ(preset.method, current_.method.method) << name;
    EXPECT_EQ(preset.extraction.plane_distance, current_.method.extraction.plane_distance) << name;
    EXPECT_EQ(static_cast<int>(preset.method), config_.method) << name;
    EXPECT_EQ(preset.noise.floor, config_.noise_floor) << name;
    EXPECT_EQ(name, config_.preset);
  }
  EXPECT_TRUE(changes_.empty());
}

TEST_F(Presets, leaveFramesAndTrackingAlone) {
  config_.gravity_frame = "world";
  config_.track_memory = 7.0;
  request();
  config_.preset = "short_range";
  request();
  EXPECT_EQ("world", config_.gravity_frame);
  EXPECT_EQ(7.0, config_.track_memory);
}

TEST_F(Presets, giveWayToWhatIsChangedBesideOrAfterThem) {
  config_.preset = "short_range";
  config_.max_range = 2.0;
  request();
  EXPECT_EQ(2.0, current_.method.scanlines.max_range);
  EXPECT_EQ(120, current_.method.extraction.min_plane_inliers);
  EXPECT_EQ("custom", config_.preset) << "it is not the preset any more";

  config_.max_range = Parameters{}.scanlines.max_range;
  request();
  EXPECT_EQ("short_range", config_.preset) << "it is again";
}

TEST_F(Presets, areAllOffered) {
  const auto descriptions = PlaneSegmenterConfig::__getParamDescriptions__();
  const auto preset = std::find_if(descriptions.begin(), descriptions.end(),
                                   [](const auto& parameter) { return parameter->name == "preset"; });
  ASSERT_NE(preset, descriptions.end());
  for (const char* name : kPresetNames) {
    EXPECT_NE((*preset)->edit_method.find("'value': '" + std::string(name) + "'"), std::string::npos) << name;
  }
}

TEST_F(Presets, ofUnknownNamesAreRefused) {
  config_.preset = "long_range";
  request();
  EXPECT_EQ("kinect", config_.preset);
  ASSERT_EQ(1U, changes_.size());
  EXPECT_NE(std::string::npos, changes_.front().find("long_range"));
}

}  // namespace
}  // namespace line_plane_segmentation
