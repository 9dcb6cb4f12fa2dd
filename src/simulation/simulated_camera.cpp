// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_camera.h"

#include <stdexcept>

namespace line_plane_segmentation::simulation {
namespace {

SimulatedCamera::Options checked(const SimulatedCamera::Options& options) {
  const auto legal = [](int side) { return side >= 1 && side <= kMaxImageSide; };
  if (!legal(options.width) || !legal(options.height)) {
    throw std::invalid_argument("the image's sides have 1 to 4096 pixels");
  }
  return options;
}

}  // namespace

CameraIntrinsics kinectIntrinsics(int width, int height) {
  const double focal_length = 525.0 * width / 640.0;
  return {focal_length, focal_length, 0.5 * (width - 1), 0.5 * (height - 1)};
}

SimulatedCamera::SimulatedCamera(const Options& options)
    : options_(checked(options)),
      intrinsics_(kinectIntrinsics(options.width, options.height)),
      room_(simulatedRoom(options.seed)),
      noise_({}, options.seed) {}

const Rendering& SimulatedCamera::capture(std::uint64_t frame, double seconds, std::uint16_t* depth_mm) {
  render(room_.scene, pose(seconds), intrinsics_, options_.width, options_.height, rendering_);
  if (options_.noise) {
    noise_.apply(rendering_, intrinsics_, frame, depth_mm);
  } else {
    toMillimetres(rendering_, depth_mm);
  }
  return rendering_;
}

}  // namespace line_plane_segmentation::simulation
