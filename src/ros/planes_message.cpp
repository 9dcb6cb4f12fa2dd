// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>
#include <cstddef>

#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {
namespace {

geometry_msgs::Polygon polygonOf(const Segmentation& segmentation, const Ring& ring) {
  geometry_msgs::Polygon polygon;
  polygon.points.reserve(static_cast<std::size_t>(ring.vertex_count));
  for (int i = 0; i < ring.vertex_count; ++i) {
    const Eigen::Vector3f& vertex = segmentation.vertices[static_cast<std::size_t>(ring.first_vertex + i)];
    geometry_msgs::Point32 point;
    point.x = vertex.x();
    point.y = vertex.y();
    point.z = vertex.z();
    polygon.points.push_back(point);
  }
  return polygon;
}

void addPolygons(const Segmentation& segmentation, const SegmentedPlane& plane, Plane& message) {
  for (int i = 0; i < plane.outer_ring_count + plane.hole_count; ++i) {
    const Ring& ring = segmentation.rings[static_cast<std::size_t>(plane.first_ring + i)];
    if (i == 0) {
      message.outline = polygonOf(segmentation, ring);
    } else if (i < plane.outer_ring_count) {
      message.other_parts.push_back(polygonOf(segmentation, ring));
    } else {
      message.holes.push_back(polygonOf(segmentation, ring));
    }
  }
}

Plane planeMessage(const Segmentation& segmentation, const SegmentedPlane& plane, std::uint32_t id) {
  Plane message;
  message.id = id;
  message.label = plane.label;
  message.coefficients.coef = {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.d};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      message.covariance[static_cast<std::size_t>(4 * row + column)] = plane.covariance(row, column);
    }
  }
  message.centroid.x = plane.centroid.x();
  message.centroid.y = plane.centroid.y();
  message.centroid.z = plane.centroid.z();
  message.inliers = plane.inliers;
  message.rms = static_cast<float>(plane.rms);
  message.area = static_cast<float>(plane.area);
  addPolygons(segmentation, plane, message);
  message.orientation = Plane::UNKNOWN;
  return message;
}

}  // namespace

void idsFromLabels(const Segmentation& segmentation, std::vector<std::uint32_t>& ids) {
  ids.clear();
  for (const SegmentedPlane& plane : segmentation.planes) ids.push_back(plane.label);
}

PlaneArray::Ptr planesMessage(const SegmentedFrame& frame) {
  const Segmentation& segmentation = frame.segmentation;
  auto message = boost::make_shared<PlaneArray>();
  message->header = frame.header;
  message->planes.reserve(segmentation.planes.size());
  for (std::size_t k = 0; k < segmentation.planes.size(); ++k) {
    message->planes.push_back(planeMessage(segmentation, segmentation.planes[k], frame.ids[k]));
  }
  message->image_width = static_cast<std::uint32_t>(segmentation.width);
  message->image_height = static_cast<std::uint32_t>(segmentation.height);
  message->valid_pixels = segmentation.valid_pixels;
  message->assigned_pixels = segmentation.assigned_pixels;
  message->processing_time = static_cast<float>(frame.processing_time);
  return message;
}

}  // namespace line_plane_segmentation
