// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <cstdint>

#include "line_plane_segmentation/palette.h"

namespace line_plane_segmentation {

/// Converts an Eigen vector to a message.
template <typename Vector>
geometry_msgs::Point pointOf(const Vector& vector) {
  geometry_msgs::Point point;
  point.x = vector.x();
  point.y = vector.y();
  point.z = vector.z();
  return point;
}

/// Converts a colour to a message without transparency.
/// @param white_fraction  fraction of white that is mixed in, 0 to 1
inline std_msgs::ColorRGBA toRgba(const Color& color, float white_fraction = 0.0F) {
  const auto channel = [white_fraction](std::uint8_t value) {
    return white_fraction + (1.0F - white_fraction) * static_cast<float>(value) / 255.0F;
  };
  std_msgs::ColorRGBA rgba;
  rgba.r = channel(color.r);
  rgba.g = channel(color.g);
  rgba.b = channel(color.b);
  rgba.a = 1.0F;
  return rgba;
}

/// Returns a marker with identity pose; colour, scale and points are not set.
inline visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const char* name_space,
                                             std::uint32_t id, int type) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = name_space;
  marker.id = static_cast<std::int32_t>(id);
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  return marker;
}

constexpr double kLineWidth = 0.02;  ///< [m] width of outlines and arrows

/// Returns the length [m] of the arrow along a plane's normal.
/// @param area  [m²] area of the plane
inline double arrowLength(double area) { return std::clamp(0.3 * std::sqrt(area), 0.05, 0.3); }

/// Returns an arrow along a plane's normal.
/// @param start   [m] point on the plane
/// @param length  [m]
template <typename Vector>
visualization_msgs::Marker makeArrow(const std_msgs::Header& header, const char* name_space, std::uint32_t id,
                                     const Vector& start, const Vector& normal, double length) {
  visualization_msgs::Marker marker = makeMarker(header, name_space, id, visualization_msgs::Marker::ARROW);
  marker.points = {pointOf(start), pointOf((start + length * normal).eval())};
  marker.scale.x = kLineWidth;
  marker.scale.y = 2.5 * kLineWidth;
  marker.scale.z = 0.25 * length;
  return marker;
}

/// Returns a message with a DELETEALL marker. Markers appended to it replace all earlier ones of the topic.
inline visualization_msgs::MarkerArray::Ptr makeMarkerArray(const std_msgs::Header& header) {
  auto message = boost::make_shared<visualization_msgs::MarkerArray>();
  message->markers.push_back(makeMarker(header, "", 0, visualization_msgs::Marker::CUBE));
  message->markers.back().action = visualization_msgs::Marker::DELETEALL;
  return message;
}

}  // namespace line_plane_segmentation
