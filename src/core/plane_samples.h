// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// A point of a plane, in the optical frame.
struct PlaneSample {
  Eigen::Vector3f point;
  int owner;  ///< index of its plane
};

/// Points of all planes on a grid of pixels, some 48 across the image.
/// @param samples  overwritten; by owner as in segmentation.planes
/// @param counts   overwritten: how many each plane has
void samplePlanes(const Segmentation& segmentation, const CameraIntrinsics& camera,
                  std::vector<PlaneSample>& samples, std::vector<int>& counts);

/// What the samples of one owner and a plane of the image have in common.
struct SampleVotes {
  int samples = 0;        ///< that are seen in pixels of the plane
  float distance = 0.0F;  ///< sum of their distances from the plane, as shares of their depths
};

/// Looks where samples would be seen, and what is seen there.
/// @param owner_count  owners are from 0 to below this
/// @param in_view      overwritten: how many of each owner's samples are within the image
/// @param votes        overwritten: of owner o and plane k in [o * number of planes + k]
void countVotes(const std::vector<PlaneSample>& samples, std::size_t owner_count,
                const Segmentation& segmentation, const CameraIntrinsics& camera, std::vector<int>& in_view,
                std::vector<SampleVotes>& votes);

}  // namespace line_plane_segmentation
