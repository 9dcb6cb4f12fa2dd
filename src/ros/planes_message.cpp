// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/hole_parts.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {
namespace {

static_assert(static_cast<int>(Orientation::kUnknown) == Plane::UNKNOWN &&
                  static_cast<int>(Orientation::kHorizontalUp) == Plane::HORIZONTAL_UP &&
                  static_cast<int>(Orientation::kHorizontalDown) == Plane::HORIZONTAL_DOWN &&
                  static_cast<int>(Orientation::kVertical) == Plane::VERTICAL &&
                  static_cast<int>(Orientation::kSlanted) == Plane::SLANTED,
              "the message has the numbers of the core");

geometry_msgs::Polygon polygonOf(const std::vector<Eigen::Vector3f>& vertices, const Ring& ring) {
  geometry_msgs::Polygon polygon;
  polygon.points.reserve(static_cast<std::size_t>(ring.vertex_count));
  for (int i = 0; i < ring.vertex_count; ++i) {
    const Eigen::Vector3f& vertex = vertices[static_cast<std::size_t>(ring.first_vertex + i)];
    geometry_msgs::Point32 point;
    point.x = vertex.x();
    point.y = vertex.y();
    point.z = vertex.z();
    polygon.points.push_back(point);
  }
  return polygon;
}

void addPolygons(const SegmentedFrame& frame, const SegmentedPlane& plane, Plane& message) {
  const std::vector<Eigen::Vector3f>& vertices = frame.published.vertices;
  for (int i = 0; i < plane.outer_ring_count + plane.hole_count; ++i) {
    const Ring& ring = frame.segmentation.rings[static_cast<std::size_t>(plane.first_ring + i)];
    if (i == 0) {
      message.outline = polygonOf(vertices, ring);
    } else if (i < plane.outer_ring_count) {
      message.other_parts.push_back(polygonOf(vertices, ring));
    } else {
      message.holes.push_back(polygonOf(vertices, ring));
    }
  }
  for (const int part : partsOfHoles(frame.segmentation, plane)) {
    message.hole_parts.push_back(static_cast<std::uint32_t>(part));
  }
}

Plane planeMessage(const SegmentedFrame& frame, const PublishedPlane& published) {
  const SegmentedPlane& plane = published.plane;
  Plane message;
  message.id = published.id;
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
  addPolygons(frame, plane, message);
  message.orientation = static_cast<std::uint8_t>(published.orientation);
  return message;
}

}  // namespace

PlaneArray::Ptr planesMessage(const SegmentedFrame& frame) {
  const Segmentation& segmentation = frame.segmentation;
  auto message = boost::make_shared<PlaneArray>();
  message->header = frame.published.header;
  message->planes.reserve(frame.published.planes.size());
  for (const PublishedPlane& published : frame.published.planes) {
    message->planes.push_back(planeMessage(frame, published));
    message->assigned_pixels += published.plane.inliers;
  }
  message->image_width = static_cast<std::uint32_t>(segmentation.width);
  message->image_height = static_cast<std::uint32_t>(segmentation.height);
  message->valid_pixels = segmentation.valid_pixels;
  message->processing_time = static_cast<float>(frame.processing_time);
  message->processing_seconds = 1e-3 * frame.processing_time;
  return message;
}

}  // namespace line_plane_segmentation
