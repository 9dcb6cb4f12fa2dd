// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "random.h"
#include "scene.h"

namespace line_plane_segmentation::simulation {

/// A place in the world where something stands: its middle, and how far it is turned about the vertical.
/// @param yaw  [rad]
Eigen::Isometry3d standingAt(const Eigen::Vector3d& foot, double yaw);

/// The room's own surfaces, all seen from inside. x from -width / 2 to width / 2, y from 0 to depth, floor at
/// 0.
struct Shell {
  double width = 0.0;   ///< [m]
  double depth = 0.0;   ///< [m]
  double height = 0.0;  ///< [m]
};

void addFloor(const Shell& shell, Scene& scene);

/// The walls at the left, at the right, and at y = 0.
/// @param height  [m] of the walls at the sides, up to where a vault springs
void addSideWalls(const Shell& shell, double height, Scene& scene);

/// The wall at y = depth, whole.
void addFarWall(const Shell& shell, Scene& scene);

/// The wall at y = depth with a door, which lies deeper than the wall. All of the wall has one label.
void addFarWallWithDoor(const Shell& shell, Random& random, Scene& scene);

void addCeiling(const Shell& shell, Scene& scene);

/// A table on four legs, with boxes on it.
/// @param place  the middle of the floor under it
void addTable(const Eigen::Isometry3d& place, Random& random, Scene& scene);

/// A set of boards between two uprights, books on them, its back to the wall.
/// @param place  on the floor at the middle of its back; it extends along x and to positive y
void addShelf(const Eigen::Isometry3d& place, Random& random, Scene& scene);

/// A board that leans against a wall.
/// @param place  on the floor where the wall is; it extends along x, its foot at positive y
void addLeaningBoard(const Eigen::Isometry3d& place, Random& random, Scene& scene);

/// A wedge, which rises to positive y.
/// @param place  on the floor at the middle of its low edge
void addRamp(const Eigen::Isometry3d& place, Random& random, Scene& scene);

/// A standing person, with curved surfaces only.
void addPerson(const Eigen::Vector3d& foot, Random& random, Scene& scene);

}  // namespace line_plane_segmentation::simulation
