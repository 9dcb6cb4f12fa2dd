// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "conversions.h"
#include "plane_message.h"
#include "plane_polygons.h"

namespace line_plane_segmentation {
namespace {

static_assert(static_cast<int>(Orientation::kUnknown) == Plane::UNKNOWN &&
                  static_cast<int>(Orientation::kHorizontalUp) == Plane::HORIZONTAL_UP &&
                  static_cast<int>(Orientation::kHorizontalDown) == Plane::HORIZONTAL_DOWN &&
                  static_cast<int>(Orientation::kVertical) == Plane::VERTICAL &&
                  static_cast<int>(Orientation::kSlanted) == Plane::SLANTED,
              "the message has the numbers of the core");

Plane planeMessage(const SegmentedFrame& frame, const PublishedPlane& published) {
  Plane message = planeWithoutPolygons(published);
  const std::vector<Eigen::Vector3f>& vertices = frame.published.vertices;
  addPolygons(
      frame.segmentation, published.plane, [&](std::size_t vertex) { return vertices[vertex]; }, message);
  return message;
}

}  // namespace

void setCoefficients(const Eigen::Vector3d& normal, double d, const Eigen::Matrix4d& covariance,
                     Plane& message) {
  message.coefficients.coef = {normal.x(), normal.y(), normal.z(), d};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      message.covariance[4 * row + column] = covariance(row, column);
    }
  }
}

Plane planeWithoutPolygons(const PublishedPlane& published) {
  const SegmentedPlane& plane = published.plane;
  Plane message;
  message.id = published.id;
  message.label = plane.label;
  setCoefficients(plane.normal, plane.d, plane.covariance, message);
  message.centroid.x = plane.centroid.x();
  message.centroid.y = plane.centroid.y();
  message.centroid.z = plane.centroid.z();
  message.inliers = plane.inliers;
  message.rms = static_cast<float>(plane.rms);
  message.area = static_cast<float>(plane.area);
  message.orientation = static_cast<std::uint8_t>(published.orientation);
  return message;
}

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
