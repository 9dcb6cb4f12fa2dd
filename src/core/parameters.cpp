// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <type_traits>

namespace line_plane_segmentation {
namespace {

// Images may be so wide that what goes with the square of their width has no int.
int roundedToCount(double value) {
  constexpr double kMost = 1e9;
  return static_cast<int>(std::lround(std::clamp(value, 1.0, kMost)));
}

// The paper's values at its two image widths. `exponent` tells how the value goes with the width beyond them.
int fromWidth(double at_qvga, double at_vga, double exponent, int width) {
  const double w = width;
  double value = 0.0;
  if (w <= 320.0) {
    value = at_qvga * std::pow(w / 320.0, exponent);
  } else if (w >= 640.0) {
    value = at_vga * std::pow(w / 640.0, exponent);
  } else {
    value = at_qvga * std::pow(at_vga / at_qvga, std::log2(w / 320.0));
  }
  return roundedToCount(value);
}

void setIfZero(int& value, int automatic) {
  if (value == 0) value = automatic;
}

template <typename T>
bool parse(const std::string& text, T& value) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  T parsed{};
  if (!(stream >> parsed) || !(stream >> std::ws).eof()) return false;
  value = parsed;
  return true;
}

bool parse(const std::string& text, bool& value) {
  if (text != "true" && text != "false" && text != "1" && text != "0") return false;
  value = text == "true" || text == "1";
  return true;
}

bool parse(const std::string& text, Method& value) {
  if (text != "paper" && text != "adaptive") return false;
  value = text == "paper" ? Method::kPaper : Method::kAdaptive;
  return true;
}

template <typename T>
std::string toText(T value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::boolalpha << value;
  return stream.str();
}

std::string toText(Method method) { return nameOf(method); }

}  // namespace

const char* nameOf(Method method) { return method == Method::kPaper ? "paper" : "adaptive"; }

std::vector<std::string> sanitize(Parameters& parameters) {
  std::vector<std::string> changes;
  const auto changed = [&changes](const std::string& name, const std::string& from, const std::string& to) {
    changes.push_back(name + " was " + from + ", is now " + to);
  };

  const std::vector<double> default_values = valuesOf(Parameters{});
  std::size_t index = 0;
  visitParameters(parameters, [&](const char* name, auto& value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    const T given = value;
    const T fallback = static_cast<T>(default_values[index++]);
    if (std::isnan(static_cast<double>(given))) value = fallback;
    value = std::min(std::max(value, static_cast<T>(min)), static_cast<T>(max));
    if (!(value == given)) changed(name, toText(given), toText(value));
  });

  int& points = parameters.candidates.points_per_segment;
  if (points % 2 == 0) {
    changed("points_per_segment", toText(points), toText(points - 1));
    --points;
  }
  int& window = parameters.lines.line_window;
  if (window == 1) {
    changed("line_window", toText(window), toText(2));
    window = 2;
  }
  ScanlineParameters& range = parameters.scanlines;
  if (range.min_range >= range.max_range) {
    changed("min_range", toText(range.min_range), toText(0.0));
    range.min_range = 0.0;
  }
  return changes;
}

Parameters resolve(const Parameters& parameters, int width) {
  Parameters p = parameters;
  const int w = std::max(width, 1);
  if (p.method == Method::kAdaptive) {
    setIfZero(p.scanlines.scanline_spacing, std::max(4, fromWidth(10, 12, 1.0, w)));
    setIfZero(p.lines.line_window,
              std::max(3, std::min(fromWidth(4, 5, 1.0, w), p.scanlines.scanline_spacing / 2)));
    setIfZero(p.lines.min_line_points, std::max(2, p.lines.line_window - 1));
    setIfZero(p.extraction.min_plane_inliers, fromWidth(525, 2100, 2.0, w));
  }
  setIfZero(p.cleanup.min_region_pixels, fromWidth(100, 400, 2.0, w));
  setIfZero(p.scanlines.scanline_spacing, fromWidth(20, 30, 1.0, w));
  setIfZero(p.lines.line_window, std::max(5, fromWidth(7, 11, 1.0, w) | 1));
  setIfZero(p.lines.min_line_points, fromWidth(23, 30, 1.0, w));
  setIfZero(p.candidates.normal_window, std::max(6, fromWidth(20, 20, 1.0, w)));
  setIfZero(p.candidates.min_window_points,
            roundedToCount(0.6 * p.candidates.normal_window * p.candidates.normal_window));
  setIfZero(p.extraction.min_plane_inliers, fromWidth(1000, 5000, 2.0, w));
  return p;
}

std::string presetNames() {
  std::string names;
  for (const char* name : kPresetNames) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

bool loadPreset(const std::string& name, Parameters& parameters) {
  const auto is_named = [&name](const char* preset) { return name == preset; };
  if (std::none_of(kPresetNames.begin(), kPresetNames.end(), is_named)) return false;
  parameters = Parameters{};
  if (name == "stereo") {
    // z² / (f b) times 0.08 px of disparity, with f = 425 px and b = 50 mm (D435, 848x480).
    parameters.noise = {0.0005, 0.0038, 0.0, 0.0};
  } else if (name == "stereo_short") {
    // The same with f = 430 px and b = 18 mm (D405).
    parameters.noise = {0.0002, 0.0103, 0.0, 0.0};
    parameters.scanlines.min_range = 0.05;
    parameters.patches.patch_distance = 0.001;
    parameters.extraction.plane_distance = 0.005;
  } else if (name == "tof") {
    // 1.5 mm up close to 4 mm at 3.5 m (Azure Kinect; Tölgyessy et al. 2021).
    parameters.noise = {0.0015, 0.0003, 0.5, 0.0};
  } else if (name == "paper") {
    parameters.method = Method::kPaper;
  } else if (name == "short_range") {
    parameters.noise = {0.0007, 0.0, 0.0, 1.0};  // steps of 1.3 mm, near and far
    parameters.scanlines.min_range = 0.1;
    parameters.scanlines.scanline_spacing = 5;
    parameters.patches.patch_noise_factor = 1.5;
    parameters.patches.patch_distance = 1e-5;
    parameters.patches.patch_flatness = 3.0;
    parameters.clusters.merge_cost = 8.0;
    parameters.clusters.coplanar_cost = 0.0;  // every face for itself
    parameters.clusters.max_curvedness = 1000.0;
    parameters.clusters.max_waviness = 1000.0;
    parameters.clusters.min_patches = 4;
    parameters.extraction.plane_distance = 0.002;
    parameters.extraction.min_plane_inliers = 120;
    parameters.cleanup.min_region_pixels = 30;
  }
  return true;
}

std::string noEffect(const std::string& name, Method method) {
  static const std::array<const char*, 7> kOnlyPaper{
      "line_fidelity",     "line_noise_factor", "points_per_segment", "normal_window",
      "min_window_points", "max_curvature",     "neighbor_distance"};
  static const std::array<const char*, 12> kOnlyAdaptive{
      "noise_scale", "distance_noise_factor", "patch_noise_factor", "patch_distance", "patch_flatness",
      "merge_cost",  "coplanar_cost",         "max_curvedness",     "max_waviness",   "max_bend",
      "min_patches", "min_region_pixels"};
  const auto is_one_of = [&name](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool is_unused = method == Method::kPaper ? is_one_of(kOnlyAdaptive) : is_one_of(kOnlyPaper);
  return is_unused ? name + " has no effect on the method " + nameOf(method) : "";
}

std::vector<double> valuesOf(const Parameters& parameters) {
  std::vector<double> values;
  visitParameters(parameters, [&values](const char*, const auto& value, auto, auto) {
    values.push_back(static_cast<double>(value));
  });
  return values;
}

std::vector<std::string> changesWithoutEffect(const Parameters& before, const Parameters& after) {
  const std::vector<double> values_before = valuesOf(before);
  std::vector<std::string> lines;
  std::size_t index = 0;
  visitParameters(after, [&](const char* name, const auto& value, auto, auto) {
    if (static_cast<double>(value) == values_before[index++]) return;
    const std::string line = noEffect(name, after.method);
    if (!line.empty()) lines.push_back(line);
  });
  return lines;
}

std::string setParameter(const std::string& name, const std::string& value, Parameters& parameters) {
  std::string problem = "no parameter is named '" + name + "'";
  if (name == "fine_spacing")
    problem += " any more: line segments end at the borders of narrow surfaces by themselves";
  visitParameters(parameters, [&](const char* known, auto& field, auto min, auto max) {
    if (name != known) return;
    using T = std::decay_t<decltype(field)>;
    T parsed{};
    if (!parse(value, parsed)) {
      problem = "'" + value + "' is no value for " + name;
    } else if (!(parsed >= static_cast<T>(min) && parsed <= static_cast<T>(max))) {
      problem = name + " = " + value + " is outside " + toText(static_cast<T>(min)) + " to " +
                toText(static_cast<T>(max));
    } else {
      field = parsed;
      problem.clear();
    }
  });
  return problem;
}

}  // namespace line_plane_segmentation
