// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <pcl_msgs/ModelCoefficients.h>
#include <pcl_msgs/PointIndices.h>
#include <sensor_msgs/Image.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <optional>
#include <string>

namespace line_plane_segmentation {

/// Selection of a plane of a message.
struct PlaneChoice {
  std::uint32_t id = 0;                     ///< only the plane with this id; 0 = the largest plane
  std::optional<std::uint8_t> orientation;  ///< only planes of this Plane::orientation
};

/// Returns the value of Plane::orientation with this name, such as "horizontal_up"; empty if there is none.
std::optional<std::uint8_t> orientationNamed(const std::string& name);

/// Returns the selected plane; null if the message has none.
const Plane* choosePlane(const PlaneArray& planes, const PlaneChoice& choice);

/// Each message has the header of `planes`. Without a plane (null) it is empty.

/// nx, ny, nz, d, as PCL's SACMODEL_PLANE has them.
pcl_msgs::ModelCoefficients::Ptr modelCoefficients(const PlaneArray& planes, const Plane* plane);

/// Returns the indices of the plane's points in an organised cloud of the same image.
/// @param labels  16UC1, of the same image. An image that is malformed gives no indices
pcl_msgs::PointIndices::Ptr pointIndices(const PlaneArray& planes, const Plane* plane,
                                         const sensor_msgs::Image& labels);

/// Returns the outline of the plane's largest part, without holes.
geometry_msgs::PolygonStamped::Ptr polygon(const PlaneArray& planes, const Plane* plane);

/// Returns markers for rviz: a DELETEALL, the outline and the normal.
visualization_msgs::MarkerArray::Ptr choiceMarkers(const PlaneArray& planes, const Plane* plane);

}  // namespace line_plane_segmentation
