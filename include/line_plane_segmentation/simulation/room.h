// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "line_plane_segmentation/simulation/camera_path.h"
#include "line_plane_segmentation/simulation/scene.h"

namespace line_plane_segmentation::simulation {

/// What stands in a room beside the floor, four walls, a table with boxes on it and a box on the floor,
/// which all rooms have.
struct RoomFeatures {
  bool ceiling = false;        ///< flat
  bool vault = false;          ///< a curved ceiling in place of the flat one
  bool door = false;           ///< in a recess of the far wall
  bool step = false;           ///< a platform in the far right corner
  bool shelf = false;          ///< with boards and books, at the left wall
  bool leaning_board = false;  ///< at the left wall, slanted
  bool ramp = false;           ///< slanted, on the floor
  bool column = false;         ///< curved
  bool person = false;         ///< curved: upright ellipsoids
  bool ball = false;           ///< curved
};

struct Room {
  Scene scene;
  CameraPath path;
  RoomFeatures features;
};

/// A room of one's own for every seed, furnished as the seed says.
Room simulatedRoom(std::uint64_t seed);

/// A room with just these features; the seed gives the sizes and places.
Room simulatedRoom(std::uint64_t seed, const RoomFeatures& features);

}  // namespace line_plane_segmentation::simulation
