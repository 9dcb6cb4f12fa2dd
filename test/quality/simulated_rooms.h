// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "labelled_set.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "renderer.h"

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

  /// A copy that stays.
  LabelledFrame labelled() const;
};

/// Which rooms a set holds. The seed of a room is its number.
struct RoomRange {
  std::uint64_t first = 1;
  std::uint64_t last = 10;
  std::uint64_t step = 1;
};

/// Rooms that were seen while working.
constexpr RoomRange kSeenRooms{1, 10};
/// Rooms that were never looked at: parameters are decided on these five ...
constexpr RoomRange kDecidingRooms{1001, 1009, 2};
/// ... and confirmed on these five.
constexpr RoomRange kConfirmingRooms{1002, 1010, 2};

/// Renders each room four times along the camera's path, at VGA, noisy.
/// In `truth` pixels without depth are not to be judged; what is curved belongs to no plane, and a label
/// on it is a false one.
void forEachSimulatedFrame(const RoomRange& rooms, const std::function<void(const SimulatedFrame&)>& visit);

/// Truth regions of this set that are smaller need not be found [px].
constexpr std::int64_t kSimulatedMinPixels = 2000;

}  // namespace line_plane_segmentation
