// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/plane_track_filter.h"
#include "object_detection.h"

namespace line_plane_segmentation {

/// Planes that are left out of ~cloud_without_planes while a gravity frame is set. Without a gravity frame
/// all planes are left out.
struct ObstacleParameters {
  /// [-] Leave out horizontal planes at floor_height. Switch off to keep the floor as an obstacle.
  bool remove_floor = true;
  /// [-] Leave out all floors and tables. Switch on if tables are not obstacles.
  bool remove_horizontal_up = false;
  /// [-] Leave out ceilings. Switch on if they are not obstacles.
  bool remove_horizontal_down = false;
  /// [-] Leave out walls. Switch on if they are not obstacles.
  bool remove_vertical = false;
  /// [-] Leave out slanted planes. Switch on if ramps are not obstacles.
  bool remove_slanted = false;
  /// [m] z coordinate of the floor in the gravity_frame. Increase to expect the floor higher; decrease to
  /// expect it lower.
  double floor_height = 0.0;
  /// [m] Largest distance of the floor's centroid from floor_height. Increase to accept uneven
  /// floors; decrease to keep low platforms as obstacles.
  double floor_tolerance = 0.1;
};

/// Calls `visitor(name, value, min, max)` for each parameter, as visitParameters() does for the method's.
template <typename ParametersType, typename Visitor>
void visitObstacleParameters(ParametersType& p, Visitor&& visitor) {
  visitor("remove_floor", p.remove_floor, false, true);
  visitor("remove_horizontal_up", p.remove_horizontal_up, false, true);
  visitor("remove_horizontal_down", p.remove_horizontal_down, false, true);
  visitor("remove_vertical", p.remove_vertical, false, true);
  visitor("remove_slanted", p.remove_slanted, false, true);
  visitor("floor_height", p.floor_height, -1000.0, 1000.0);
  visitor("floor_tolerance", p.floor_tolerance, 0.0, 10.0);
}

/// Parameters of the outputs for robots: obstacle cloud, objects and fused planes.
struct RobotParameters {
  ObstacleParameters obstacles;
  ObjectParameters objects;
  FusionParameters fusion;
};

/// Calls `visitor(name, value, min, max)` for all of them.
template <typename ParametersType, typename Visitor>
void visitRobotParameters(ParametersType& p, Visitor&& visitor) {
  visitObstacleParameters(p.obstacles, visitor);
  visitObjectParameters(p.objects, visitor);
  visitFusionParameters(p.fusion, visitor);
}

}  // namespace line_plane_segmentation
