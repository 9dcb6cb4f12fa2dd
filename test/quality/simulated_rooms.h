// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/simulation/renderer.h"

namespace line_plane_segmentation {

/// One picture of a simulated room. What it refers to is gone with the next one.
struct SimulatedFrame {
  std::string name;                         ///< "room03_10s"
  const std::vector<std::uint16_t>& depth;  ///< [mm] with a Kinect's noise, 0 = no depth
  const std::vector<std::uint16_t>& truth;  ///< labels as evaluate_segmentation reads them
  const simulation::Rendering& rendering;   ///< what is there
  const CameraIntrinsics& camera;

  int width() const { return rendering.width; }
  int height() const { return rendering.height; }
};

/// The set of simulated rooms that doc/quality.md reports: rooms 1 to 10, each four times, at VGA, noisy.
/// In `truth` pixels without depth are not to be judged; what is curved belongs to no plane, and a label
/// on it is a false one.
void forEachSimulatedFrame(const std::function<void(const SimulatedFrame&)>& visit);

/// Truth regions of this set that are smaller need not be found [px].
constexpr std::int64_t kSimulatedMinPixels = 2000;

}  // namespace line_plane_segmentation
