// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "line_plane_segmentation/orientation.h"
#include "line_plane_segmentation/ros/location_parameters.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// True if planes of this orientation are published.
bool isPublished(const OrientationParameters& parameters, Orientation orientation);

/// A plane as the messages tell of it.
struct PublishedPlane {
  SegmentedPlane plane;  ///< in the frame of PublishedPlanes::header; its rings are those of the segmentation
  std::uint32_t id = 0;
  Orientation orientation = Orientation::kUnknown;
};

/// What is published of the planes of a segmentation, in the frame that the user wants them in.
struct PublishedPlanes {
  std_msgs::Header header;                                      ///< the depth image's stamp, and that frame
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< takes points of the optical frame there
  std::vector<PublishedPlane> planes;     ///< those whose orientation is wanted, the largest first
  std::vector<Eigen::Vector3f> vertices;  ///< [m] Segmentation::vertices in that frame
};

/// Fills in `planes` and `vertices`, by the `placement` that is there.
/// @param ids  of the planes, in the order of segmentation.planes
/// @param up   unit, in the optical frame; unknown: all orientations are, too
void publishPlanes(const Segmentation& segmentation, const std::vector<std::uint32_t>& ids,
                   const std::optional<Eigen::Vector3d>& up, const OrientationParameters& parameters,
                   PublishedPlanes& published);

}  // namespace line_plane_segmentation
