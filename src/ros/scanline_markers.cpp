// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>
#include <vector>

#include "conversions.h"
#include "marker_tools.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

constexpr Color kRows{255, 165, 60};
constexpr Color kColumns{90, 185, 255};
constexpr Color kNormals{255, 90, 150};

Marker makeLines(const SegmentedFrame& frame, const char* name_space, Color color, double width) {
  Marker marker = makeMarker(frame.published.header, name_space, 0, Marker::LINE_LIST);
  marker.color = toRgba(color);
  marker.scale.x = width;
  return marker;
}

Eigen::Vector3d rayOf(const CameraIntrinsics& camera, int u, int v) {
  return {(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0};
}

bool isInRange(double z, const DepthRange& range) { return z >= range.min && z <= range.max; }

class LineDrawer {
 public:
  explicit LineDrawer(const SegmentedFrame& frame) : frame_(frame) {}

  // Skips segments out of range: a line can run far off where its scan has a gap.
  void draw(const LineSegment& segment, Marker& marker) const {
    const Eigen::Vector3d first = rayTo(segment, segment.first);
    const Eigen::Vector3d last = rayTo(segment, segment.last);
    const double first_z = depthOn(segment, first);
    const double last_z = depthOn(segment, last);
    if (!isInRange(first_z, frame_.range) || !isInRange(last_z, frame_.range)) return;
    add(first_z * first, last_z * last, marker);
  }

  void draw(const PlaneCandidate& candidate, Marker& marker) const {
    constexpr double kLength = 0.04;  // fraction of the depth, for a constant length in the image
    const Eigen::Vector3d ray = rayOf(frame_.camera, candidate.u, candidate.v);
    const double z = -candidate.d / candidate.normal.dot(ray);
    if (!isInRange(z, frame_.range)) return;
    add(z * ray, z * ray + kLength * z * candidate.normal, marker);
  }

 private:
  Eigen::Vector3d rayTo(const LineSegment& segment, int pixel) const {
    return segment.direction == ScanDirection::kRow ? rayOf(frame_.camera, pixel, segment.scanline)
                                                    : rayOf(frame_.camera, segment.scanline, pixel);
  }

  // Depth at which the ray intersects the line Sx cos(alpha) + Sy sin(alpha) = r, with Sx = k z and Sy =
  // along z (Eq. 1-3).
  static double depthOn(const LineSegment& segment, const Eigen::Vector3d& ray) {
    const bool row = segment.direction == ScanDirection::kRow;
    const double along = row ? ray.x() : ray.y();
    const double k = std::hypot(row ? ray.y() : ray.x(), 1.0);
    return segment.r / (k * std::cos(segment.alpha) + along * std::sin(segment.alpha));
  }

  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Marker& marker) const {
    marker.points.push_back(pointOf(frame_.published.target_from_optical * from));
    marker.points.push_back(pointOf(frame_.published.target_from_optical * to));
  }

  const SegmentedFrame& frame_;
};

}  // namespace

visualization_msgs::MarkerArray::Ptr scanlineMarkers(const SegmentedFrame& frame,
                                                     const std::vector<LineSegment>& segments,
                                                     const std::vector<PlaneCandidate>& candidates) {
  constexpr double kSegmentWidth = 0.006;  // [m]
  constexpr double kNormalWidth = 0.004;   // [m]
  Marker rows = makeLines(frame, "rows", kRows, kSegmentWidth);
  Marker columns = makeLines(frame, "columns", kColumns, kSegmentWidth);
  Marker normals = makeLines(frame, "candidates", kNormals, kNormalWidth);

  const LineDrawer drawer(frame);
  for (const LineSegment& segment : segments) {
    drawer.draw(segment, segment.direction == ScanDirection::kRow ? rows : columns);
  }
  for (const PlaneCandidate& candidate : candidates) drawer.draw(candidate, normals);

  visualization_msgs::MarkerArray::Ptr message = makeMarkerArray(frame.published.header);
  for (Marker* marker : {&rows, &columns, &normals}) {
    if (!marker->points.empty()) message->markers.push_back(std::move(*marker));
  }
  return message;
}

}  // namespace line_plane_segmentation
