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

/// Which plane of a message is converted.
struct PlaneChoice {
  std::uint32_t id = 0;                     ///< this one only; 0 = the largest
  std::optional<std::uint8_t> orientation;  ///< only planes of this Plane::orientation
};

/// The value of Plane::orientation with this name: "horizontal_up" and so on. Empty if there is none.
std::optional<std::uint8_t> orientationNamed(const std::string& name);

/// @return the chosen plane, null if the message has none
const Plane* choosePlane(const PlaneArray& planes, const PlaneChoice& choice);

/// Each message has the header of `planes`. Without a plane (null) it is empty.

/// nx, ny, nz, d, as PCL's SACMODEL_PLANE has them.
pcl_msgs::ModelCoefficients::Ptr modelCoefficients(const PlaneArray& planes, const Plane* plane);

/// Indices of the plane's points in an organised cloud of the same image.
/// @param labels  16UC1, of the same image. An image that is malformed gives no indices
pcl_msgs::PointIndices::Ptr pointIndices(const PlaneArray& planes, const Plane* plane,
                                         const sensor_msgs::Image& labels);

/// The outline of the plane's largest part, without holes.
geometry_msgs::PolygonStamped::Ptr polygon(const PlaneArray& planes, const Plane* plane);

/// For rviz: a DELETEALL, the outline and the normal.
visualization_msgs::MarkerArray::Ptr choiceMarkers(const PlaneArray& planes, const Plane* plane);

}  // namespace line_plane_segmentation
