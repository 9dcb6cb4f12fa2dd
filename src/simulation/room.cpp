// SPDX-License-Identifier: BSD-3-Clause
#include "room.h"

#include "furniture.h"
#include "random.h"

namespace line_plane_segmentation::simulation {
namespace {

using Eigen::Vector3d;

constexpr double kQuarterTurn = 1.57079632679489661923;

void addRoof(const Shell& shell, const RoomFeatures& features, Scene& scene) {
  if (features.vault) {
    const double springing = 0.7 * shell.height;
    addSideWalls(shell, springing, scene);
    scene.addCurvedBody(vault({0.0, 0.0, springing}, 0.5 * shell.width, shell.height - springing));
  } else {
    addSideWalls(shell, shell.height, scene);
    if (features.ceiling) addCeiling(shell, scene);
  }
}

void addShell(const Shell& shell, const RoomFeatures& features, Random& random, Scene& scene) {
  addFloor(shell, scene);
  addRoof(shell, features, scene);
  if (features.door) {
    addFarWallWithDoor(shell, random, scene);
  } else {
    addFarWall(shell, scene);
  }
}

void addStep(const Shell& shell, Random& random, Scene& scene) {
  const Vector3d size(random.uniform(1.0, 1.6), random.uniform(0.8, 1.2), random.uniform(0.12, 0.24));
  scene.addBox(standingAt({0.5 * (shell.width - size.x()), shell.depth - 0.5 * size.y(), 0.0}, 0.0), size);
}

void addBoxOnFloor(Random& random, Scene& scene) {
  const Vector3d size(random.uniform(0.3, 0.5), random.uniform(0.25, 0.45), random.uniform(0.2, 0.45));
  scene.addBox(
      standingAt({random.uniform(-1.5, -1.25), random.uniform(1.9, 2.5), 0.0}, random.uniform(-0.7, 0.7)),
      size);
}

/// The left wall's own: shelf or board, each in its part of it.
void furnishLeftWall(const Shell& shell, const RoomFeatures& features, Random& random, Scene& scene) {
  const double wall = -0.5 * shell.width;
  if (features.shelf) {
    addShelf(standingAt({wall, random.uniform(3.3, 3.6), 0.0}, -kQuarterTurn), random, scene);
  }
  if (features.leaning_board) {
    addLeaningBoard(standingAt({wall, random.uniform(1.9, 2.2), 0.0}, -kQuarterTurn), random, scene);
  }
}

void addCurvedThings(const RoomFeatures& features, Random& random, Scene& scene) {
  if (features.column)
    scene.addCurvedBody(column({random.uniform(1.3, 1.6), 3.6, 0.0}, random.uniform(0.12, 0.2)));
  if (features.person) addPerson({random.uniform(-0.9, -0.5), random.uniform(3.5, 3.8), 0.0}, random, scene);
  if (features.ball) {
    const double radius = random.uniform(0.11, 0.2);
    scene.addCurvedBody(ellipsoid({random.uniform(-0.6, -0.2), random.uniform(1.6, 1.8), radius},
                                  Vector3d::Constant(radius)));
  }
}

RoomFeatures chooseFeatures(Random& random) {
  RoomFeatures features;
  features.vault = random.chance(0.15);
  features.ceiling = !features.vault && random.chance(0.6);
  features.door = random.chance(0.6);
  features.step = random.chance(0.4);
  features.shelf = random.chance(0.5);
  features.leaning_board = random.chance(0.35);
  features.ramp = random.chance(0.35);
  features.column = random.chance(0.25);
  features.person = random.chance(0.35);
  features.ball = random.chance(0.35);
  return features;
}

}  // namespace

Room simulatedRoom(std::uint64_t seed) {
  Random random(mixBits(seed));
  return simulatedRoom(seed, chooseFeatures(random));
}

Room simulatedRoom(std::uint64_t seed, const RoomFeatures& features) {
  Random random(seed);
  const Shell shell{random.uniform(4.4, 5.4), random.uniform(4.6, 5.6), random.uniform(2.4, 2.8)};
  const Vector3d table(random.uniform(-0.1, 0.3), random.uniform(2.4, 2.8), 0.0);
  const Vector3d station(random.uniform(-0.2, 0.2), random.uniform(0.75, 0.9), random.uniform(1.25, 1.45));

  Scene scene;
  addShell(shell, features, random, scene);
  addTable(standingAt(table, random.uniform(-0.45, 0.45)), random, scene);
  addBoxOnFloor(random, scene);
  furnishLeftWall(shell, features, random, scene);
  if (features.step) addStep(shell, random, scene);
  if (features.ramp)
    addRamp(standingAt({1.55, random.uniform(1.9, 2.2), 0.0}, random.uniform(-0.3, 0.3)), random, scene);
  addCurvedThings(features, random, scene);
  return {scene, CameraPath(station, table + Vector3d(0.0, 0.0, 0.75), seed), features};
}

}  // namespace line_plane_segmentation::simulation
