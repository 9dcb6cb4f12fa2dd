// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include <cmath>

namespace line_plane_segmentation::simulation {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// A box whose bottom's middle is at `foot` of the place.
void addBoxAt(const Isometry3d& place, const Vector3d& foot, const Vector3d& size, Scene& scene) {
  scene.addBox(place * Eigen::Translation3d(foot), size);
}

}  // namespace

Isometry3d standingAt(const Vector3d& foot, double yaw) {
  return Eigen::Translation3d(foot) * Eigen::AngleAxisd(yaw, Vector3d::UnitZ());
}

void addFloor(const Shell& shell, Scene& scene) {
  scene.addRectangle({-0.5 * shell.width, 0.0, 0.0}, {shell.width, 0.0, 0.0}, {0.0, shell.depth, 0.0});
}

void addSideWalls(const Shell& shell, double height, Scene& scene) {
  const double right = 0.5 * shell.width;
  const Vector3d up(0.0, 0.0, height);
  scene.addRectangle({-right, 0.0, 0.0}, {0.0, shell.depth, 0.0}, up);
  scene.addRectangle({right, shell.depth, 0.0}, {0.0, -shell.depth, 0.0}, up);
  scene.addRectangle({right, 0.0, 0.0}, {-shell.width, 0.0, 0.0}, {0.0, 0.0, shell.height});
}

void addFarWall(const Shell& shell, Scene& scene) {
  scene.addRectangle({-0.5 * shell.width, shell.depth, 0.0}, {shell.width, 0.0, 0.0},
                     {0.0, 0.0, shell.height});
}

void addFarWallWithDoor(const Shell& shell, Random& random, Scene& scene) {
  const double left = -0.5 * shell.width + random.uniform(0.3, 0.8);
  const double right = left + random.uniform(0.85, 1.0);
  const double top = random.uniform(1.95, 2.1);
  const double recess = random.uniform(0.08, 0.2);
  const double y = shell.depth;
  const double wall_right = 0.5 * shell.width;
  const Vector3d inward(0.0, recess, 0.0);

  scene.addRectangle({-wall_right, y, 0.0}, {left + wall_right, 0.0, 0.0}, {0.0, 0.0, shell.height});
  scene.addRectangle({left, y, top}, {right - left, 0.0, 0.0}, {0.0, 0.0, shell.height - top});
  scene.addRectangle({right, y, 0.0}, {wall_right - right, 0.0, 0.0}, {0.0, 0.0, shell.height});

  scene.addRectangle({left, y + recess, 0.0}, {right - left, 0.0, 0.0}, {0.0, 0.0, top});
  scene.addRectangle({left, y, 0.0}, inward, {0.0, 0.0, top});
  scene.addRectangle({right, y + recess, 0.0}, -inward, {0.0, 0.0, top});
  scene.addRectangle({left, y, top}, inward, {right - left, 0.0, 0.0});
  scene.addRectangle({left, y, 0.0}, {right - left, 0.0, 0.0}, inward);
}

void addCeiling(const Shell& shell, Scene& scene) {
  scene.addRectangle({-0.5 * shell.width, 0.0, shell.height}, {0.0, shell.depth, 0.0},
                     {shell.width, 0.0, 0.0});
}

void addTable(const Isometry3d& place, Random& random, Scene& scene) {
  const Vector3d top(random.uniform(1.2, 1.5), random.uniform(0.7, 0.9), random.uniform(0.025, 0.05));
  const double height = random.uniform(0.68, 0.78);
  const double leg = random.uniform(0.05, 0.08);
  addBoxAt(place, {0.0, 0.0, height - top.z()}, top, scene);
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      // Set in from the edge, so that no leg is flush with the board.
      addBoxAt(place, {x * (top.x() - leg - 0.08), y * (top.y() - leg - 0.08), 0.0},
               {leg, leg, height - top.z()}, scene);
    }
  }
  constexpr int kPlaces = 4;
  for (int i = 0; i < kPlaces; ++i) {
    if (i > 0 && random.chance(0.25)) continue;
    const Vector3d size(random.uniform(0.12, 0.24), random.uniform(0.1, 0.2), random.uniform(0.06, 0.3));
    const double x = top.x() * ((i + 0.5) / kPlaces - 0.5);
    const double y = (top.y() - 0.35) * random.uniform(-0.5, 0.5);
    scene.addBox(place * standingAt({x, y, height}, random.uniform(-0.6, 0.6)), size);
  }
}

void addShelf(const Isometry3d& place, Random& random, Scene& scene) {
  const double width = random.uniform(0.8, 1.1);
  const double depth = random.uniform(0.25, 0.32);
  const double pitch = random.uniform(0.36, 0.44);
  constexpr double kThickness = 0.025;
  constexpr int kBoards = 5;
  const double height = (kBoards - 1) * pitch + kThickness;
  for (const double side : {-0.5, 0.5}) {
    addBoxAt(place, {side * (width - kThickness), 0.5 * depth, 0.0}, {kThickness, depth, height}, scene);
  }
  for (int board = 0; board < kBoards; ++board) {
    // A little behind the uprights' front.
    addBoxAt(place, {0.0, 0.5 * (depth - 0.01), board * pitch},
             {width - 2.0 * kThickness, depth - 0.01, kThickness}, scene);
    if (board + 1 == kBoards) break;
    double x = -0.5 * width + 0.06;
    while (random.chance(0.8)) {
      const Vector3d book(random.uniform(0.03, 0.09), random.uniform(0.14, 0.22), random.uniform(0.18, 0.3));
      if (x + book.x() > 0.5 * width - 0.06) break;
      addBoxAt(place, {x + 0.5 * book.x(), 0.5 * book.y() + 0.02, board * pitch + kThickness}, book, scene);
      x += book.x() + 0.001;
    }
  }
}

void addLeaningBoard(const Isometry3d& place, Random& random, Scene& scene) {
  const Vector3d size(random.uniform(0.7, 1.1), 0.02, random.uniform(1.2, 1.7));
  const double lean = random.uniform(0.25, 0.5);
  const double foot = size.z() * std::sin(lean) + 0.02;
  scene.addBox(place * Eigen::Translation3d(0.0, foot, 0.0) * Eigen::AngleAxisd(lean, Vector3d::UnitX()),
               size);
}

void addRamp(const Isometry3d& place, Random& random, Scene& scene) {
  const double half = random.uniform(0.3, 0.45);
  const double length = random.uniform(0.8, 1.2);
  const double rise = length * std::tan(random.uniform(0.25, 0.5));
  const Vector3d left = place * Vector3d(-half, 0.0, 0.0);
  const Vector3d right = place * Vector3d(half, 0.0, 0.0);
  const Vector3d left_back = place * Vector3d(-half, length, 0.0);
  const Vector3d right_back = place * Vector3d(half, length, 0.0);
  const Vector3d left_top = place * Vector3d(-half, length, rise);
  const Vector3d right_top = place * Vector3d(half, length, rise);
  scene.addPolygon({left, right, right_top, left_top});
  scene.addPolygon({left_back, left, left_top});
  scene.addPolygon({right, right_back, right_top});
  scene.addPolygon({right_back, left_back, left_top, right_top});
}

void addPerson(const Vector3d& foot, Random& random, Scene& scene) {
  const double height = random.uniform(1.6, 1.85);
  const Vector3d up = Vector3d::UnitZ();
  scene.addCurvedBody(ellipsoid(foot + 0.25 * height * up, {0.16, 0.13, 0.28 * height}));
  scene.addCurvedBody(ellipsoid(foot + 0.65 * height * up, {0.24, 0.15, 0.22 * height}));
  scene.addCurvedBody(ellipsoid(foot + 0.92 * height * up, {0.09, 0.11, 0.08 * height}));
}

}  // namespace line_plane_segmentation::simulation
