// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "conversions.h"
#include "label_anchor.h"
#include "marker_tools.h"
#include "text_overlap.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

// All rings of a plane as one LINE_LIST marker.
Marker outlineMarker(const SegmentedFrame& frame, const PublishedPlane& published) {
  // The plane's own colour would be invisible on the cloud.
  constexpr float kWhiteFraction = 0.6F;
  const SegmentedPlane& plane = published.plane;
  Marker marker = makeMarker(frame.published.header, "outlines", published.id, Marker::LINE_LIST);
  marker.color = toRgba(colorOf(published.id), kWhiteFraction);
  marker.scale.x = kLineWidth;
  const std::vector<Eigen::Vector3f>& vertices = frame.published.vertices;
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = frame.segmentation.rings[plane.first_ring + r];
    for (int i = 0; i < ring.vertex_count; ++i) {
      const int next = (i + 1) % ring.vertex_count;
      marker.points.push_back(pointOf(vertices[ring.first_vertex + i]));
      marker.points.push_back(pointOf(vertices[ring.first_vertex + next]));
    }
  }
  return marker;
}

// Start of the normal's arrow, in the frame of the messages: the intersection of the anchor's ray with the
// plane, or the centroid if there is no anchor.
Eigen::Vector3d arrowStart(const SegmentedFrame& frame, const PublishedPlane& published,
                           const LabelAnchor& anchor) {
  const SegmentedPlane& seen = frame.segmentation.planes[published.plane.label - std::size_t{1}];
  const CameraIntrinsics& camera = frame.camera;
  const Eigen::Vector3d ray((anchor.u - camera.cx) / camera.fx, (anchor.v - camera.cy) / camera.fy, 1.0);
  const double toward = -seen.normal.dot(ray);
  if (!anchor.found || toward <= 0.0) return published.plane.centroid;
  return frame.published.target_from_optical * (seen.d / toward * ray);
}

Marker normalMarker(const std_msgs::Header& header, const PublishedPlane& published,
                    const Eigen::Vector3d& start) {
  constexpr float kWhiteFraction = 0.6F;
  Marker marker = makeArrow(header, "normals", published.id, start, published.plane.normal,
                            arrowLength(published.plane.area));
  marker.color = toRgba(colorOf(published.id), kWhiteFraction);
  return marker;
}

std::string textOf(const PublishedPlane& published) {
  char area[32];
  std::snprintf(area, sizeof area, "%.2f", published.plane.area);
  std::string text = std::to_string(published.id) + ": " + area + " m^2";
  if (published.orientation != Orientation::kUnknown) {
    std::string orientation = nameOf(published.orientation);
    std::replace(orientation.begin(), orientation.end(), '_', ' ');
    text += "\n" + orientation;
  }
  return text;
}

// Grows with the plane, and with the distance, so that it is legible on a wall as well as on a table.
double textHeight(const SegmentedPlane& plane, double distance) {
  return std::clamp(0.09 * std::sqrt(plane.area), 0.02 * distance, 0.04 * distance);
}

// Offset from the start of the arrow to the centre of the text: below the arrow, and far enough in front of
// the plane that no corner of the text intersects it, both in the camera's view. rviz rotates texts towards
// its viewer, who looks in about the same direction.
Eigen::Vector3d textOffset(const SegmentedFrame& frame, const SegmentedPlane& plane, double height) {
  const double half_height = 1.2 * height;  // height of two lines
  const double half_width = 4.0 * height;
  constexpr double kGap = 0.03;    // [m]
  constexpr double kAbout = 0.35;  // [rad]
  const Eigen::Matrix3d axes =
      frame.published.target_from_optical.linear();  // image axes: right, down, forward
  const Eigen::Vector3d slope = (axes.transpose() * plane.normal).cwiseAbs();
  const double sinks = half_width * (slope.x() + kAbout * slope.z()) + half_height * slope.y();
  const Eigen::Vector3d down = axes.col(1);
  const Eigen::Vector3d below = (down - down.dot(plane.normal) * plane.normal).stableNormalized();
  return 1.3 * half_height * below + (sinks + kGap) * plane.normal;
}

// The id alone where the whole text would cover a larger plane's; an empty text where that would, too.
Marker textMarker(const SegmentedFrame& frame, const PublishedPlane& published, const Eigen::Vector3d& start,
                  TextOverlapFilter& overlap_filter) {
  const Eigen::Isometry3d optical_from_published = frame.published.target_from_optical.inverse();
  Marker marker = makeMarker(frame.published.header, "ids", published.id, Marker::TEXT_VIEW_FACING);
  marker.color = toRgba({255, 255, 255});
  marker.scale.z = textHeight(published.plane, (optical_from_published * start).norm());
  const Eigen::Vector3d position = start + textOffset(frame, published.plane, marker.scale.z);
  marker.pose.position = pointOf(position);
  for (const std::string& text : {textOf(published), std::to_string(published.id)}) {
    if (!overlap_filter.addIfFree(optical_from_published * position, marker.scale.z, text)) continue;
    marker.text = text;
    break;
  }
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray::Ptr planeMarkers(const SegmentedFrame& frame) {
  const std_msgs::Header& header = frame.published.header;
  visualization_msgs::MarkerArray::Ptr message = makeMarkerArray(header);
  const std::vector<LabelAnchor> anchors = labelAnchors(frame.segmentation);
  TextOverlapFilter overlap_filter(frame.camera);
  for (const PublishedPlane& published : frame.published.planes) {
    const Eigen::Vector3d start =
        arrowStart(frame, published, anchors[published.plane.label - std::size_t{1}]);
    Marker outline = outlineMarker(frame, published);
    if (!outline.points.empty()) message->markers.push_back(std::move(outline));
    message->markers.push_back(normalMarker(header, published, start));
    Marker text = textMarker(frame, published, start, overlap_filter);
    if (!text.text.empty()) message->markers.push_back(std::move(text));
  }
  return message;
}

}  // namespace line_plane_segmentation
