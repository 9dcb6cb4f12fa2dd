// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_camera_parameters.h"

#include <algorithm>
#include <stdexcept>

namespace line_plane_segmentation {
namespace {

void require(bool condition, const std::string& name, const std::string& demand) {
  if (!condition) throw std::invalid_argument("~" + name + " must be " + demand);
}

/// Reads a parameter into `value`, which stays as it is if none is given. roscpp alone would take one of the
/// wrong type for one that is not given.
template <typename Type>
void read(const ros::NodeHandle& nh, const std::string& name, const std::string& demand, Type& value) {
  require(!nh.hasParam(name) || nh.getParam(name, value), name, demand);
}

}  // namespace

SimulatedCameraParameters readParameters(const ros::NodeHandle& nh) {
  SimulatedCameraParameters parameters;
  int seed = static_cast<int>(parameters.camera.seed);
  read(nh, "seed", "a whole number", seed);
  parameters.camera.seed = static_cast<std::uint64_t>(seed);

  const std::string side = "a whole number from 1 to " + std::to_string(simulation::kMaxImageSide);
  int& width = parameters.camera.width;
  read(nh, "width", side, width);
  require(width >= 1 && width <= simulation::kMaxImageSide, "width", side);
  int& height = parameters.camera.height;
  height = std::max(1, width * 3 / 4);
  read(nh, "height", side, height);
  require(height >= 1 && height <= simulation::kMaxImageSide, "height", side);
  read(nh, "noise", "true or false", parameters.camera.noise);

  read(nh, "rate", "a number of hertz", parameters.rate);
  require(parameters.rate > 0.0 && parameters.rate <= 1000.0, "rate", "above 0 and at most 1000 hertz");
  read(nh, "frame_id", "a text", parameters.frame_id);
  require(!parameters.frame_id.empty(), "frame_id", "the name of a frame");
  read(nh, "world_frame", "a text", parameters.world_frame);
  require(!parameters.world_frame.empty(), "world_frame", "the name of a frame");
  read(nh, "publish_tf", "true or false", parameters.publish_tf);
  return parameters;
}

}  // namespace line_plane_segmentation
