// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

/// What the tests of outlines share: label images to trace, and slow, plain checks of what comes out.
namespace line_plane_segmentation {

using Polygon = std::vector<Eigen::Vector2d>;

/// A label image with as many planes as its largest label, each facing the camera.
Segmentation segmentationOf(int width, int height, std::vector<std::uint16_t> labels);

/// The same from a picture in characters: '1' to '9' are labels, anything else is no plane.
Segmentation segmentationOf(const std::vector<std::string>& rows);

/// Another plane for a label: where it meets the optical axis it is `distance` [m] away.
void tilt(const Eigen::Vector3d& normal, double distance, SegmentedPlane& plane);

/// A camera for images of this size, that sees 30 degrees to each side.
CameraIntrinsics outlineCamera(int width, int height);

/// The rings of a plane, as they look in the picture [px].
std::vector<Polygon> ringsInImage(const Segmentation& segmentation, const SegmentedPlane& plane,
                                  const CameraIntrinsics& camera);

/// The rings of a plane in coordinates on it, that look from the camera as x to the right and y up.
std::vector<Polygon> ringsOnPlane(const Segmentation& segmentation, const SegmentedPlane& plane);

/// Shoelace formula: positive if counterclockwise where y goes up.
double signedArea(const Polygon& ring);

/// Whether a point is inside an odd number of rings.
bool isInside(const std::vector<Polygon>& rings, const Eigen::Vector2d& point);

/// From a point to the nearest point of a ring.
double distanceToRing(const Polygon& ring, const Eigen::Vector2d& point);

/// What is wrong with rings that should be simple polygons that do not touch, by looking at every pair of
/// edges: empty if nothing is.
std::string faultOf(const std::vector<Polygon>& rings);

/// What is wrong with the bookkeeping of rings and with their vertices: ranges, finite, on their planes.
std::string faultOf(const Segmentation& segmentation);

}  // namespace line_plane_segmentation
