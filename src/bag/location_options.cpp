// SPDX-License-Identifier: BSD-3-Clause
#include "location_options.h"

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <sstream>
#include <type_traits>

#include "parameter_options.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

// All parameters except texts.
template <typename Visitor>
void visitNumbers(LocationParameters& p, Visitor&& visitor) {
  visitTrackingParameters(p.tracking, visitor);
  visitOrientationParameters(p.orientation, visitor);
  visitor("tf_patience", p.frames.tf_patience, 0.0, 1.0);
}

template <typename Visitor>
void visitTexts(LocationParameters& p, Visitor&& visitor) {
  visitor("target_frame", p.frames.target_frame);
  visitor("gravity_frame", p.frames.gravity_frame);
  visitor("fixed_frame", p.frames.fixed_frame);
}

template <typename T>
bool parse(const std::string& text, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    value = text == "true";
    return value || text == "false";
  } else {
    return boost::conversion::try_lexical_convert(text, value);
  }
}

template <typename T>
std::string toText(T value) {
  std::ostringstream text;
  text << std::boolalpha << value;
  return text.str();
}

}  // namespace

bool setLocationParameter(const std::string& name, const std::string& value, LocationParameters& parameters) {
  bool known = false;
  visitNumbers(parameters, [&](const std::string& candidate, auto& field, auto min, auto max) {
    if (name != candidate) return;
    known = true;
    std::decay_t<decltype(field)> parsed{};
    if (!parse(value, parsed)) throw BadInput("'" + value + "' is no value for " + name);
    if (!(parsed >= min && parsed <= max)) {
      throw BadInput(name + " = " + value + " is outside " + toText(min) + " to " + toText(max));
    }
    field = parsed;
  });
  visitTexts(parameters, [&](const std::string& candidate, std::string& frame) {
    if (name != candidate) return;
    known = true;
    frame = !value.empty() && value.front() == '/' ? value.substr(1) : value;
  });
  if (name == "tf_fallback") {
    known = true;
    if (value != kNoTransform && value != kLatestTransform) {
      throw BadInput("'" + value + "' is no value for tf_fallback; there are none and latest");
    }
    parameters.frames.tf_fallback = value;
  }
  return known;
}

std::string locationParameterList() {
  std::string list = "Parameters of frames, orientations and ids\n";
  LocationParameters defaults;
  visitTexts(defaults, [&list](const std::string& name, const std::string&) {
    list += parameterLine(name, "none", "or the name of a frame in the bag's tf");
  });
  visitNumbers(defaults, [&list](const std::string& name, auto value, auto min, auto max) {
    list += parameterLine(name, toText(value), toText(min) + " to " + toText(max));
  });
  list += parameterLine("tf_fallback", defaults.frames.tf_fallback,
                        "or latest: the newest transform for one that is late");
  return list;
}

}  // namespace line_plane_segmentation
