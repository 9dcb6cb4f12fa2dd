// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "line_plane_segmentation/ros/conversions.h"
#include "line_plane_segmentation/ros/palette.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

constexpr double kLineWidth = 0.02;  // [m]

// The plane's own colour would not be seen on the cloud.
constexpr float kWhitened = 0.6F;

template <typename Vector>
geometry_msgs::Point pointOf(const Vector& vector) {
  geometry_msgs::Point point;
  point.x = vector.x();
  point.y = vector.y();
  point.z = vector.z();
  return point;
}

float whitened(std::uint8_t channel) {
  return kWhitened + (1.0F - kWhitened) * static_cast<float>(channel) / 255.0F;
}

Marker makeMarker(const std_msgs::Header& header, const char* name_space, std::uint32_t id, int type) {
  Marker marker;
  marker.header = header;
  marker.ns = name_space;
  marker.id = static_cast<std::int32_t>(id);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  const Color color = colorOf(id);
  marker.color.r = whitened(color.r);
  marker.color.g = whitened(color.g);
  marker.color.b = whitened(color.b);
  marker.color.a = 1.0F;
  return marker;
}

// All rings of the plane as one list of lines.
Marker outlineMarker(const SegmentedFrame& frame, const PublishedPlane& published) {
  const SegmentedPlane& plane = published.plane;
  Marker marker = makeMarker(frame.published.header, "outlines", published.id, Marker::LINE_LIST);
  marker.scale.x = kLineWidth;
  const std::vector<Eigen::Vector3f>& vertices = frame.published.vertices;
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = frame.segmentation.rings[static_cast<std::size_t>(plane.first_ring + r)];
    for (int i = 0; i < ring.vertex_count; ++i) {
      const int next = (i + 1) % ring.vertex_count;
      marker.points.push_back(pointOf(vertices[static_cast<std::size_t>(ring.first_vertex + i)]));
      marker.points.push_back(pointOf(vertices[static_cast<std::size_t>(ring.first_vertex + next)]));
    }
  }
  return marker;
}

double arrowLength(const SegmentedPlane& plane) {
  return std::min(std::max(0.3 * std::sqrt(plane.area), 0.05), 0.4);
}

double textHeight(const SegmentedPlane& plane) {
  return std::min(std::max(0.3 * std::sqrt(plane.area), 0.03), 0.12);
}

Marker normalMarker(const std_msgs::Header& header, const PublishedPlane& published) {
  const SegmentedPlane& plane = published.plane;
  Marker marker = makeMarker(header, "normals", published.id, Marker::ARROW);
  const double length = arrowLength(plane);
  marker.points = {pointOf(plane.centroid), pointOf((plane.centroid + length * plane.normal).eval())};
  marker.scale.x = kLineWidth;
  marker.scale.y = 2.5 * kLineWidth;
  marker.scale.z = 0.25 * length;
  return marker;
}

Marker textMarker(const std_msgs::Header& header, const PublishedPlane& published) {
  const SegmentedPlane& plane = published.plane;
  Marker marker = makeMarker(header, "ids", published.id, Marker::TEXT_VIEW_FACING);
  marker.pose.position = pointOf((plane.centroid + 1.2 * arrowLength(plane) * plane.normal).eval());
  marker.scale.z = textHeight(plane);
  char area[32];
  std::snprintf(area, sizeof area, "%.2f", plane.area);
  marker.text = std::to_string(published.id) + ": " + area + " m^2";
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray::Ptr planeMarkers(const SegmentedFrame& frame) {
  const std_msgs::Header& header = frame.published.header;
  auto markers = boost::make_shared<visualization_msgs::MarkerArray>();
  Marker delete_all = makeMarker(header, "", 0, Marker::CUBE);
  delete_all.action = Marker::DELETEALL;
  markers->markers.push_back(delete_all);

  for (const PublishedPlane& published : frame.published.planes) {
    Marker outline = outlineMarker(frame, published);
    if (!outline.points.empty()) markers->markers.push_back(std::move(outline));
    markers->markers.push_back(normalMarker(header, published));
    markers->markers.push_back(textMarker(header, published));
  }
  return markers;
}

}  // namespace line_plane_segmentation
