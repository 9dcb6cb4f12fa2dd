// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "line_plane_segmentation/segmentation.h"
#include "location_parameters.h"
#include "published_planes.h"
#include "transform_lookup.h"

namespace line_plane_segmentation {

/// Poses of the camera for one image, as results of tf lookups. The lookup of an unused frame is the identity
/// and counts as found.
struct CameraPoses {
  TransformLookup target;
  TransformLookup gravity;
  TransformLookup fixed;

  static constexpr std::size_t kCount = 3;
  std::array<const TransformLookup*, kCount> all() const { return {&target, &gravity, &fixed}; }

  /// Returns true if any lookup has this status.
  bool has(TransformLookup::Status status) const;
};

/// Computes target-frame coordinates, orientation and ids of the planes of consecutive images. Never waits
/// for tf. Not thread-safe.
class PlaneLocator {
 public:
  /// @param transforms  must outlive this
  explicit PlaneLocator(tf2::BufferCore& transforms) : transforms_(transforms) {}

  /// Sets the parameters for the next images.
  void setParameters(const LocationParameters& parameters);
  const LocationParameters& parameters() const { return parameters_; }

  /// Looks up the transforms needed for an image. Can be called repeatedly.
  CameraPoses lookUp(const std_msgs::Header& header) const;

  /// If tf_fallback is "latest", replaces poses that were not found by the newest known ones.
  void fallBack(const std_msgs::Header& header, CameraPoses& poses) const;

  /// Computes ids, orientations and target-frame coordinates of the planes. Ids restart if timestamps jump
  /// back, or forward by more than a minute.
  /// @param header  header of the image, its frame_id without a leading slash
  /// @param poses   result of lookUp(), in which the target is found
  /// @return the published planes, valid until the next call
  const PublishedPlanes& locate(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                const std_msgs::Header& header, const CameraPoses& poses);

  /// Returns the number of planes of the last image beyond the tracker's limit.
  std::size_t untracked() const { return tracker_.untracked(); }

 private:
  static std::optional<Eigen::Isometry3d> poseIn(const std::string& frame, const TransformLookup& lookup);
  std::optional<Eigen::Isometry3d> updateMotion(const CameraPoses& poses);
  bool isTimeJump(const ros::Time& stamp) const;

  tf2::BufferCore& transforms_;
  LocationParameters parameters_;
  PlaneTracker tracker_;
  std::optional<ros::Time> last_stamp_;
  std::optional<Eigen::Isometry3d> last_pose_;  // camera pose in the fixed frame
  PublishedPlanes published_;
};

}  // namespace line_plane_segmentation
