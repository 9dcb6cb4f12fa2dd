// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "camera_path.h"
#include "scene.h"

namespace line_plane_segmentation::simulation {

/// Optional content of a room. Every room has a floor, four walls, a table with boxes on it and a box on
/// the floor.
struct RoomFeatures {
  bool ceiling = false;        ///< flat
  bool vault = false;          ///< a curved ceiling instead of the flat one
  bool door = false;           ///< in a recess of the far wall
  bool step = false;           ///< a platform in the far right corner
  bool shelf = false;          ///< with boards and books, at the left wall
  bool leaning_board = false;  ///< at the left wall, slanted
  bool ramp = false;           ///< slanted, on the floor
  bool column = false;         ///< curved
  bool person = false;         ///< curved: upright ellipsoids
  bool ball = false;           ///< curved
};

/// A furnished room and the path of a camera in it.
struct Room {
  Scene scene;            ///< faces and curved bodies, z up
  CameraPath path;        ///< path of the camera
  RoomFeatures features;  ///< optional content
};

/// Returns a room whose content, sizes and positions depend on the seed.
Room simulatedRoom(std::uint64_t seed);

/// Returns a room with the given content; sizes and positions depend on the seed.
Room simulatedRoom(std::uint64_t seed, const RoomFeatures& features);

}  // namespace line_plane_segmentation::simulation
