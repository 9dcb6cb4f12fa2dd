// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "line_plane_segmentation/orientation.h"
#include "line_plane_segmentation/segmentation.h"
#include "location_parameters.h"

namespace line_plane_segmentation {

/// Returns true if planes of this orientation are published.
bool isPublished(const OrientationParameters& parameters, Orientation orientation);

/// Published plane: coefficients in the target frame, id and orientation.
struct PublishedPlane {
  SegmentedPlane plane;  ///< in the frame of PublishedPlanes::header; its rings refer to the segmentation
  std::uint32_t id = 0;
  Orientation orientation = Orientation::kUnknown;
};

/// Poses of the camera in the gravity frame and the fixed frame.
struct FramePoses {
  bool gravity_frame_is_set = false;                      ///< true if a gravity frame is set
  std::optional<Eigen::Isometry3d> gravity_from_optical;  ///< empty if not set, or unknown to tf
  std::string fixed_frame;                                ///< empty if no frame is set
  std::optional<Eigen::Isometry3d> fixed_from_optical;    ///< empty if not set, or unknown to tf
};

/// The published planes of a segmentation, in the target frame.
struct PublishedPlanes {
  std_msgs::Header header;  ///< timestamp of the depth image, and the target frame
  Eigen::Isometry3d target_from_optical =
      Eigen::Isometry3d::Identity();   ///< maps points of the optical frame to the target frame
  std::vector<PublishedPlane> planes;  ///< planes of published orientations, largest first
  std::vector<Orientation>
      orientations;  ///< orientations of all planes, in the order of Segmentation::planes
  FramePoses poses;
  std::vector<Eigen::Vector3f> vertices;  ///< [m] Segmentation::vertices in the target frame
};

/// Sets `planes` and `vertices`, using the transform that is already set.
/// @param ids  ids of the planes, in the order of segmentation.planes
/// @param up  unit vector in the optical frame; if empty, all orientations are unknown
void publishPlanes(const Segmentation& segmentation, const std::vector<std::uint32_t>& ids,
                   const std::optional<Eigen::Vector3d>& up, const OrientationParameters& parameters,
                   PublishedPlanes& published);

}  // namespace line_plane_segmentation
