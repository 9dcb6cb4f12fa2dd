// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace line_plane_segmentation {
namespace {

std::vector<std::string> names() {
  std::vector<std::string> names;
  const Parameters parameters;
  visitParameters(parameters, [&](const char* name, const auto&, auto, auto) { names.emplace_back(name); });
  return names;
}

/// Calls `change(field, min, max)` for the parameter of that name.
template <typename Change>
void changeOne(const std::string& name, Parameters& parameters, Change change) {
  visitParameters(parameters, [&](const char* known, auto& field, auto min, auto max) {
    if (name == known) change(field, min, max);
  });
}

/// Expects sanitize() to change the one parameter and to say so in one line.
void expectOneChange(const std::string& name, Parameters& parameters) {
  const std::vector<std::string> changes = sanitize(parameters);
  ASSERT_EQ(changes.size(), 1U) << name;
  EXPECT_EQ(changes[0].substr(0, name.size() + 1), name + ' ');
  EXPECT_TRUE(sanitize(parameters).empty()) << name;
}

TEST(Parameters, HaveNamesOfTheirOwn) {
  const std::vector<std::string> all = names();
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
}

TEST(Sanitize, LeavesDefaultsAndPresetsAlone) {
  for (const char* preset : kPresetNames) {
    Parameters parameters;
    ASSERT_TRUE(loadPreset(preset, parameters));
    const std::vector<double> before = valuesOf(parameters);
    EXPECT_TRUE(sanitize(parameters).empty()) << preset;
    EXPECT_EQ(valuesOf(parameters), before) << preset;
  }
}

TEST(Sanitize, PutsNanToTheDefault) {
  for (const std::string& name : names()) {
    Parameters parameters;
    bool is_double = false;
    changeOne(name, parameters, [&](auto& field, auto, auto) {
      if constexpr (std::is_same_v<std::decay_t<decltype(field)>, double>) {
        field = std::nan("");
        is_double = true;
      }
    });
    if (!is_double) continue;
    expectOneChange(name, parameters);
    EXPECT_EQ(valuesOf(parameters), valuesOf(Parameters{})) << name;
  }
}

TEST(Sanitize, BringsEveryNumberWithinItsBounds) {
  for (const std::string& name : names()) {
    for (const bool above : {false, true}) {
      Parameters parameters;
      bool is_number = false;
      changeOne(name, parameters, [&](auto& field, auto, auto) {
        using T = std::decay_t<decltype(field)>;
        if constexpr (std::is_same_v<T, double>) {
          field = above ? HUGE_VAL : -HUGE_VAL;
          is_number = true;
        } else if constexpr (std::is_same_v<T, int>) {
          field = above ? std::numeric_limits<T>::max() : std::numeric_limits<T>::min();
          is_number = true;
        } else if constexpr (std::is_same_v<T, Method>) {
          field = static_cast<Method>(above ? 1000 : -1000);
          is_number = true;
        }
      });
      if (!is_number) continue;
      if ((name == "min_range" && above) || (name == "max_range" && !above))
        continue;  // see OpensAnEmptyRange
      expectOneChange(name, parameters);
      changeOne(name, parameters, [&](auto& field, auto min, auto max) {
        using T = std::decay_t<decltype(field)>;
        EXPECT_EQ(field, static_cast<T>(above ? max : min)) << name;
      });
    }
  }
}

TEST(Sanitize, OpensAnEmptyRange) {
  Parameters parameters;
  parameters.scanlines.min_range = 5.0;
  parameters.scanlines.max_range = 5.0;
  expectOneChange("min_range", parameters);
  EXPECT_EQ(parameters.scanlines.min_range, 0.0);
  EXPECT_EQ(parameters.scanlines.max_range, 5.0);

  parameters.scanlines.min_range = 1e9;  // out of bounds as well: two lines
  EXPECT_EQ(sanitize(parameters).size(), 2U);
  EXPECT_LT(parameters.scanlines.min_range, parameters.scanlines.max_range);

  parameters.scanlines = {};
  parameters.scanlines.max_range = -1.0;
  EXPECT_EQ(sanitize(parameters).size(), 2U);
  EXPECT_LT(parameters.scanlines.min_range, parameters.scanlines.max_range);
}

TEST(Sanitize, MakesPointsPerSegmentOdd) {
  for (const int given : {2, 4}) {
    Parameters parameters;
    parameters.candidates.points_per_segment = given;
    expectOneChange("points_per_segment", parameters);
    EXPECT_EQ(parameters.candidates.points_per_segment, given - 1);
  }
}

// One point makes no line; 0 stands for "from the image's width".
TEST(Sanitize, MakesWindowsOfOnePointLonger) {
  Parameters parameters;
  parameters.lines.line_window = 1;
  expectOneChange("line_window", parameters);
  EXPECT_EQ(parameters.lines.line_window, 2);
  for (const int given : {0, 2, 3}) {
    parameters.lines.line_window = given;
    EXPECT_TRUE(sanitize(parameters).empty()) << given;
  }
}

TEST(Sanitize, TellsOfEachChange) {
  Parameters parameters;
  parameters.noise.floor = std::nan("");
  parameters.lines.line_fidelity = -1.0;
  parameters.candidates.points_per_segment = 4;
  EXPECT_EQ(sanitize(parameters).size(), 3U);
}

TEST(SetParameter, KnowsEveryParameterAndItsBounds) {
  for (const std::string& name : names()) {
    Parameters parameters;
    changeOne(name, parameters, [&](auto& field, [[maybe_unused]] auto min, [[maybe_unused]] auto max) {
      using T = std::decay_t<decltype(field)>;
      if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
        std::ostringstream low, high;
        low << std::scientific << min - static_cast<T>(1);
        high << std::scientific << max + static_cast<T>(1);
        const T before = field;
        EXPECT_NE(setParameter(name, low.str(), parameters), "") << name;
        EXPECT_NE(setParameter(name, high.str(), parameters), "") << name;
        EXPECT_EQ(field, before) << name;
        std::ostringstream bound;
        bound.precision(17);
        bound << max;
        EXPECT_EQ(setParameter(name, bound.str(), parameters), "") << name;
        EXPECT_EQ(field, static_cast<T>(max)) << name;
      }
    });
  }
}

TEST(SetParameter, ReadsEachType) {
  Parameters parameters;
  EXPECT_EQ(
      setParameter("fine_spacing", "3", parameters),
      "no parameter is named 'fine_spacing' any more: line segments end at the borders of narrow surfaces "
      "by themselves");
  EXPECT_EQ(setParameter("plane_distance", "0.025", parameters), "");
  EXPECT_EQ(parameters.extraction.plane_distance, 0.025);
  EXPECT_EQ(setParameter("max_curvature", " 1e-3 ", parameters), "");
  EXPECT_EQ(parameters.candidates.max_curvature, 1e-3);
  EXPECT_EQ(setParameter("min_plane_inliers", "1234", parameters), "");
  EXPECT_EQ(parameters.extraction.min_plane_inliers, 1234);
  EXPECT_EQ(setParameter("method", "paper", parameters), "");
  EXPECT_EQ(parameters.method, Method::kPaper);
  EXPECT_EQ(setParameter("method", "adaptive", parameters), "");
  EXPECT_EQ(parameters.method, Method::kAdaptive);
  for (const char* off : {"false", "0"}) {
    parameters.outlines.trace_outlines = true;
    EXPECT_EQ(setParameter("trace_outlines", off, parameters), "");
    EXPECT_FALSE(parameters.outlines.trace_outlines);
  }
  for (const char* on : {"true", "1"}) {
    parameters.outlines.trace_outlines = false;
    EXPECT_EQ(setParameter("trace_outlines", on, parameters), "");
    EXPECT_TRUE(parameters.outlines.trace_outlines);
  }
}

TEST(SetParameter, RefusesWhatIsNoValueAndNamesIt) {
  const struct {
    const char *name, *value;
  } cases[] = {
      {"plane_distance", ""},       {"plane_distance", "wide"},
      {"plane_distance", "0.02m"},  {"plane_distance", "0.02 0.03"},
      {"plane_distance", "nan"},    {"plane_distance", "inf"},
      {"plane_distance", "1e999"},  {"plane_distance", "0,02"},
      {"min_plane_inliers", "1.5"}, {"min_plane_inliers", "many"},
      {"min_plane_inliers", "1e3"}, {"min_plane_inliers", "99999999999999999999"},
      {"min_plane_inliers", ""},    {"trace_outlines", "yes"},
      {"trace_outlines", "2"},      {"trace_outlines", ""},
      {"method", "fast"},           {"method", "0"},
      {"method", "Paper"},          {"scanline_spacing", "-1"},
  };
  for (const auto& c : cases) {
    Parameters parameters;
    const std::string problem = setParameter(c.name, c.value, parameters);
    EXPECT_NE(problem.find(c.name), std::string::npos) << c.name << " = '" << c.value << "': " << problem;
    EXPECT_EQ(valuesOf(parameters), valuesOf(Parameters{})) << c.name << " = " << c.value;
  }
}

TEST(SetParameter, RefusesAnUnknownNameAndNamesIt) {
  Parameters parameters;
  for (const char* name : {"", "plane_distanc", "Plane_Distance", "plane_distance "}) {
    EXPECT_NE(setParameter(name, "0.02", parameters).find("'" + std::string(name) + "'"), std::string::npos);
    EXPECT_EQ(valuesOf(parameters), valuesOf(Parameters{}));
  }
}

TEST(Presets, AreKinectPaperAndShortRange) {
  Parameters parameters;
  parameters.lines.line_fidelity = 17.0;
  ASSERT_TRUE(loadPreset("kinect", parameters));
  EXPECT_EQ(valuesOf(parameters), valuesOf(Parameters{}));

  ASSERT_TRUE(loadPreset("paper", parameters));
  EXPECT_EQ(parameters.method, Method::kPaper);
  EXPECT_EQ(parameters.extraction.plane_distance, 0.02);
  EXPECT_EQ(parameters.extraction.neighbor_distance, 0.03);

  ASSERT_TRUE(loadPreset("short_range", parameters));
  EXPECT_LT(parameters.extraction.plane_distance, Parameters{}.extraction.plane_distance);
}

TEST(Presets, OfStereoCamerasHaveErrorsThatGrowWithTheSquaredDepth) {
  Parameters stereo, near, tof;
  ASSERT_TRUE(loadPreset("stereo", stereo));
  ASSERT_TRUE(loadPreset("stereo_short", near));
  ASSERT_TRUE(loadPreset("tof", tof));
  constexpr double kDisparityError = 0.08, kFocalLength = 425.0, kBaseline = 0.05;  // [px], [px], [m]
  EXPECT_NEAR(stereo.noise.sigma(4.0) - stereo.noise.sigma(0.0),
              16.0 * kDisparityError / (kFocalLength * kBaseline), 1e-3);
  EXPECT_LT(near.noise.sigma(0.1), stereo.noise.sigma(0.1));
  EXPECT_EQ(near.patches.patch_distance, 0.001);
  EXPECT_GT(near.noise.sigma(2.0), stereo.noise.sigma(2.0));
  EXPECT_LT(tof.noise.sigma(3.5), 0.1 * stereo.noise.sigma(3.5));
  for (const Parameters& p : {stereo, near, tof}) EXPECT_EQ(p.noise.scale, 0.0) << "measured in each image";
}

TEST(ChangesWithoutEffect, AreThoseOfParametersThatTheMethodDoesNotUse) {
  Parameters before, after;
  EXPECT_TRUE(changesWithoutEffect(before, after).empty());
  after.lines.line_fidelity = 2.0;
  after.clusters.merge_cost = 3.0;
  EXPECT_EQ(changesWithoutEffect(before, after),
            std::vector<std::string>{"line_fidelity has no effect on the method adaptive"});
  after.method = before.method = Method::kPaper;
  EXPECT_EQ(changesWithoutEffect(before, after),
            std::vector<std::string>{"merge_cost has no effect on the method paper"});
  EXPECT_EQ(changesWithoutEffect(after, after), std::vector<std::string>{});
}

TEST(Presets, OfAnUnknownNameChangeNothing) {
  Parameters parameters;
  parameters.lines.line_fidelity = 17.0;
  const std::vector<double> before = valuesOf(parameters);
  for (const char* name : {"", "Kinect", "long_range"}) {
    EXPECT_FALSE(loadPreset(name, parameters)) << name;
    EXPECT_EQ(valuesOf(parameters), before) << name;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
