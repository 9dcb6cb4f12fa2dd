// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/Plane.h>

#include <cstddef>
#include <cstdint>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Writes the polygons of a plane into its message: outline, other parts, and holes with the index of their
/// part.
/// @param plane       a plane of `segmentation`, in any frame
/// @param position_of  returns the vertex with an index into Segmentation::vertices, as an Eigen vector
template <typename PositionOf>
void addPolygons(const Segmentation& segmentation, const SegmentedPlane& plane, PositionOf&& position_of,
                 Plane& message) {
  const auto polygon_of = [&](const Ring& ring) {
    geometry_msgs::Polygon polygon;
    polygon.points.reserve(static_cast<std::size_t>(ring.vertex_count));
    for (int i = 0; i < ring.vertex_count; ++i) {
      const Eigen::Vector3f vertex = position_of(static_cast<std::size_t>(ring.first_vertex + i));
      geometry_msgs::Point32 point;
      point.x = vertex.x();
      point.y = vertex.y();
      point.z = vertex.z();
      polygon.points.push_back(point);
    }
    return polygon;
  };
  for (int i = 0; i < plane.outer_ring_count + plane.hole_count; ++i) {
    const Ring& ring = segmentation.rings[plane.first_ring + i];
    if (i == 0) {
      message.outline = polygon_of(ring);
    } else if (i < plane.outer_ring_count) {
      message.other_parts.push_back(polygon_of(ring));
    } else {
      message.holes.push_back(polygon_of(ring));
    }
  }
  for (const int part : partsOfHoles(segmentation, plane)) {
    message.hole_parts.push_back(static_cast<std::uint32_t>(part));
  }
}

}  // namespace line_plane_segmentation
