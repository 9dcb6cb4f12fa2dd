// SPDX-License-Identifier: BSD-3-Clause
#include "conversions_of_planes.h"

#include <Eigen/Core>
#include <boost/make_shared.hpp>
#include <cstddef>

#include "line_plane_segmentation/orientation.h"
#include "marker_tools.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

std::uint16_t pixelOf(const std::uint8_t* bytes, bool is_bigendian) {
  const std::uint8_t low = bytes[is_bigendian ? 1 : 0], high = bytes[is_bigendian ? 0 : 1];
  return static_cast<std::uint16_t>(high << 8 | low);
}

bool isLabelImage(const sensor_msgs::Image& image) {
  const std::uint64_t step = image.step;
  return image.encoding == "16UC1" && step >= std::uint64_t{2} * image.width &&
         image.data.size() >= step * image.height;
}

geometry_msgs::Point toPoint(const geometry_msgs::Point32& point) {
  geometry_msgs::Point result;
  result.x = static_cast<double>(point.x);
  result.y = static_cast<double>(point.y);
  result.z = static_cast<double>(point.z);
  return result;
}

}  // namespace

std::optional<std::uint8_t> orientationNamed(const std::string& name) {
  for (int i = 0; i < kOrientationCount; ++i) {
    if (name == nameOf(static_cast<Orientation>(i))) return static_cast<std::uint8_t>(i);
  }
  return {};
}

const Plane* choosePlane(const PlaneArray& planes, const PlaneChoice& choice) {
  const Plane* chosen = nullptr;
  for (const Plane& plane : planes.planes) {
    if (choice.id != 0 && plane.id != choice.id) continue;
    if (choice.orientation && plane.orientation != *choice.orientation) continue;
    if (chosen == nullptr || plane.inliers > chosen->inliers) chosen = &plane;
  }
  return chosen;
}

pcl_msgs::ModelCoefficients::Ptr modelCoefficients(const PlaneArray& planes, const Plane* plane) {
  auto message = boost::make_shared<pcl_msgs::ModelCoefficients>();
  message->header = planes.header;
  if (plane == nullptr) return message;
  for (const double value : plane->coefficients.coef) message->values.push_back(static_cast<float>(value));
  return message;
}

pcl_msgs::PointIndices::Ptr pointIndices(const PlaneArray& planes, const Plane* plane,
                                         const sensor_msgs::Image& labels) {
  auto message = boost::make_shared<pcl_msgs::PointIndices>();
  message->header = planes.header;
  if (plane == nullptr || !isLabelImage(labels)) return message;
  message->indices.reserve(plane->inliers);
  std::int32_t index = 0;
  for (std::size_t v = 0; v < labels.height; ++v) {
    const std::uint8_t* row = labels.data.data() + v * labels.step;
    for (std::size_t u = 0; u < labels.width; ++u, ++index) {
      if (pixelOf(row + 2 * u, labels.is_bigendian != 0) == plane->label) message->indices.push_back(index);
    }
  }
  return message;
}

geometry_msgs::PolygonStamped::Ptr polygon(const PlaneArray& planes, const Plane* plane) {
  auto message = boost::make_shared<geometry_msgs::PolygonStamped>();
  message->header = planes.header;
  if (plane != nullptr) message->polygon = plane->outline;
  return message;
}

visualization_msgs::MarkerArray::Ptr choiceMarkers(const PlaneArray& planes, const Plane* plane) {
  visualization_msgs::MarkerArray::Ptr message = makeMarkerArray(planes.header);
  if (plane == nullptr) return message;
  Marker outline = makeMarker(planes.header, "outline", plane->id, Marker::LINE_STRIP);
  outline.color = toRgba(colorOf(plane->id));
  outline.scale.x = kLineWidth;
  for (const geometry_msgs::Point32& point : plane->outline.points) outline.points.push_back(toPoint(point));
  if (!outline.points.empty()) {
    outline.points.push_back(outline.points.front());
    message->markers.push_back(outline);
  }
  const geometry_msgs::Point& centroid = plane->centroid;
  const auto& coef = plane->coefficients.coef;
  Marker normal =
      makeArrow(planes.header, "normal", plane->id, Eigen::Vector3d(centroid.x, centroid.y, centroid.z),
                Eigen::Vector3d(coef[0], coef[1], coef[2]), arrowLength(static_cast<double>(plane->area)));
  normal.color = outline.color;
  message->markers.push_back(normal);
  return message;
}

}  // namespace line_plane_segmentation
