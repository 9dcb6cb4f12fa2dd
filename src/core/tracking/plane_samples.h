// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
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
  int plane = 0;          ///< index of the plane in the image
  int samples = 0;        ///< samples of the owner that are seen in pixels of the plane, at least 1
  float distance = 0.0F;  ///< sum of their distances from the plane, as fractions of their depths
};

/// The votes of all owners as a sparse matrix: it holds only the pairs of owner and plane that have a sample
/// in common, so that its size is bounded by the number of samples, not by owners times planes.
class VoteTable {
 public:
  /// Projects the samples into the image and looks up the plane at each pixel.
  /// @param owner_count  owners are from 0 to below this
  void count(const std::vector<PlaneSample>& samples, std::size_t owner_count,
             const Segmentation& segmentation, const CameraIntrinsics& camera);

  /// Number of the owner's samples that project into the image.
  int inView(std::size_t owner) const { return in_view_[owner]; }

  /// The owner's pairs, each plane at most once, in no particular order.
  const SampleVotes* begin(std::size_t owner) const { return votes_.data() + first_[owner]; }
  const SampleVotes* end(std::size_t owner) const { return begin(owner) + pairs_[owner]; }

 private:
  void add(std::size_t owner, int plane, float distance);

  std::vector<int> in_view_;        // per owner
  std::vector<std::size_t> first_;  // index of each owner's first pair in votes_
  std::vector<int> pairs_;          // per owner
  std::vector<SampleVotes> votes_;  // space for one pair per sample
};

}  // namespace line_plane_segmentation
