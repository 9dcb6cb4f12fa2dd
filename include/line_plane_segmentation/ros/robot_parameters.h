// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/plane_track_filter.h"
#include "line_plane_segmentation/robot/object_detection.h"

namespace line_plane_segmentation {

/// Which planes are left out of the cloud without planes while a gravity frame is set. Without one it is all
/// planes.
struct ObstacleParameters {
  bool remove_floor = true;             ///< horizontal, visible from above, at floor_height
  bool remove_horizontal_up = false;    ///< floors, tables
  bool remove_horizontal_down = false;  ///< ceilings
  bool remove_vertical = false;         ///< walls
  bool remove_slanted = false;          ///< ramps
  double floor_height = 0.0;            ///< [m] z of the floor in the gravity frame
  double floor_tolerance = 0.1;         ///< [m] that the floor's centroid may be off floor_height
};

/// As visitParameters() for the method's parameters: the one list of names and bounds.
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

/// All that decides what is made from the planes for a robot's use.
struct RobotParameters {
  ObstacleParameters obstacles;
  ObjectParameters objects;
  FusionParameters fusion;
};

/// Calls `visitor` for all of them.
template <typename ParametersType, typename Visitor>
void visitRobotParameters(ParametersType& p, Visitor&& visitor) {
  visitObstacleParameters(p.obstacles, visitor);
  visitObjectParameters(p.objects, visitor);
  visitFusionParameters(p.fusion, visitor);
}

}  // namespace line_plane_segmentation
