// SPDX-License-Identifier: BSD-3-Clause
#include "start_parameters.h"

#include <sstream>
#include <stdexcept>

namespace line_plane_segmentation {
namespace {

constexpr char kPeriod[] = "diagnostic_period";
constexpr double kShortestPeriod = 0.0;    // [s]
constexpr double kLongestPeriod = 3600.0;  // [s]

// roscpp treats a parameter of the wrong type as not set.
int readInt(const ros::NodeHandle& nh, const std::string& name, int fallback, int min, int max) {
  int value = fallback;
  const bool given = nh.hasParam(name);
  if ((given && !nh.getParam(name, value)) || value < min || value > max) {
    throw std::invalid_argument("~" + name + " must be a whole number from " + std::to_string(min) + " to " +
                                std::to_string(max));
  }
  return value;
}

double readDouble(const ros::NodeHandle& nh, const std::string& name, double fallback, double min,
                  double max) {
  double value = fallback;
  const bool given = nh.hasParam(name);
  // Negated, so that NaN is refused.
  if ((given && !nh.getParam(name, value)) || !(value >= min && value <= max)) {
    std::ostringstream problem;
    problem << "~" << name << " must be a number from " << min << " to " << max;
    throw std::invalid_argument(problem.str());
  }
  return value;
}

// True if clouds are to be read in the place of images.
bool readsClouds(const ros::NodeHandle& nh) {
  std::string input = "image";
  const bool given = nh.hasParam("input");
  if ((given && !nh.getParam("input", input)) || (input != "image" && input != "cloud")) {
    throw std::invalid_argument("~input must be image or cloud");
  }
  return input == "cloud";
}

InfoMatching readMatching(const ros::NodeHandle& nh) {
  std::string name = nameOf(InfoMatching::kAuto);
  const bool readable = !nh.hasParam("info_matching") || nh.getParam("info_matching", name);
  const std::optional<InfoMatching> matching = infoMatchingOf(name);
  if (!readable || !matching) throw std::invalid_argument("~info_matching must be exact, latest or auto");
  return *matching;
}

RectificationMode readRectificationMode(const ros::NodeHandle& nh) {
  bool value = false;
  if (nh.getParam("rectify", value)) return value ? RectificationMode::kAlways : RectificationMode::kNever;
  std::string name = "auto";
  const bool readable = !nh.hasParam("rectify") || nh.getParam("rectify", name);
  const std::optional<RectificationMode> rectify = rectificationModeOf(name);
  if (!readable || !rectify) throw std::invalid_argument("~rectify must be auto, true or false");
  return *rectify;
}

}  // namespace

StartParameters readStartParameters(const ros::NodeHandle& private_nh) {
  StartParameters parameters;
  parameters.clouds = readsClouds(private_nh);
  parameters.queue_size = readInt(private_nh, "queue_size", parameters.queue_size, 1, 1000);
  parameters.info_matching = readMatching(private_nh);
  parameters.rectify = readRectificationMode(private_nh);
  InputLimits& limits = parameters.limits;
  limits.max_pixels = static_cast<std::uint64_t>(
      readInt(private_nh, "max_pixels", static_cast<int>(limits.max_pixels), 1, 1 << 28));
  limits.depth_unit = readDouble(private_nh, "depth_unit", limits.depth_unit, kMinDepthUnit, kMaxDepthUnit);
  readDouble(private_nh, kPeriod, 1.0, kShortestPeriod, kLongestPeriod);
  return parameters;
}

std::vector<std::string> startParameterNames() {
  return {"input", "queue_size", "max_pixels", "info_matching", "depth_unit", "rectify"};
}

void removeInvalidDiagnosticPeriod(const ros::NodeHandle& private_nh) {
  try {
    readDouble(private_nh, kPeriod, 1.0, kShortestPeriod, kLongestPeriod);
  } catch (const std::invalid_argument&) {
    private_nh.deleteParam(kPeriod);
  }
}

}  // namespace line_plane_segmentation
