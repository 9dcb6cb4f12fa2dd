// SPDX-License-Identifier: BSD-3-Clause
#include "input_options.h"

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <sstream>

#include "parameter_options.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28U;  // as the nodelet's

template <typename Number>
std::string toText(Number number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

template <typename Number>
Number parse(const std::string& name, const std::string& value, Number min, Number max) {
  Number number{};
  if (!boost::conversion::try_lexical_convert(value, number)) {
    throw BadInput("'" + value + "' is no value for " + name);
  }
  if (!(number >= min && number <= max)) {
    throw BadInput(name + " = " + value + " is outside " + toText(min) + " to " + toText(max));
  }
  return number;
}

}  // namespace

bool setInputParameter(const std::string& name, const std::string& value, BagTask& task) {
  if (name == "depth_unit") {
    task.limits.depth_unit = parse(name, value, kMinDepthUnit, kMaxDepthUnit);
  } else if (name == "max_pixels") {
    task.limits.max_pixels = parse<std::uint64_t>(name, value, 1, kMostPixels);
  } else if (name == "info_matching") {
    const std::optional<InfoMatching> matching = infoMatchingOf(value);
    if (!matching)
      throw BadInput("'" + value + "' is no value for info_matching; there are exact, latest and auto");
    task.topics.matching = *matching;
  } else if (name == "rectify") {
    const std::optional<RectificationMode> rectify = rectificationModeOf(value);
    if (!rectify) throw BadInput("'" + value + "' is no value for rectify; there are auto, true and false");
    task.topics.rectify = *rectify;
  } else {
    return false;
  }
  return true;
}

std::string inputParameterList() {
  const InputLimits defaults;
  return "Parameters of the input\n" +
         parameterLine(
             "depth_unit", toText(defaults.depth_unit),
             toText(kMinDepthUnit) + " to " + toText(kMaxDepthUnit) + " m: one count of a 16-bit image") +
         parameterLine("info_matching", nameOf(TopicChoice().matching),
                       "exact or latest: which camera_info an image goes with") +
         parameterLine("rectify", "auto",
                       "true or false: whether distortion that camera_info tells of is undone") +
         parameterLine("max_pixels", toText(defaults.max_pixels), "1 to " + toText(kMostPixels));
}

}  // namespace line_plane_segmentation
