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
#include "line_plane_segmentation/ros/location_parameters.h"
#include "line_plane_segmentation/ros/published_planes.h"
#include "line_plane_segmentation/segmentation.h"
#include "transform_lookup.h"

namespace line_plane_segmentation {

/// Results of the tf lookups for one image. A lookup that was not needed counts as found, with the
/// identity.
struct CameraPlaces {
  TransformLookup target;
  TransformLookup gravity;
  TransformLookup fixed;

  static constexpr std::size_t kCount = 3;
  std::array<const TransformLookup*, kCount> all() const { return {&target, &gravity, &fixed}; }

  /// Returns true if any lookup has this answer.
  bool has(TransformLookup::Answer answer) const;
};

/// Computes target-frame coordinates, orientation and ids of the planes of consecutive images. Never waits
/// for tf. Not thread-safe.
class PlaneLocator {
 public:
  /// @param transforms  must outlive this
  explicit PlaneLocator(tf2::BufferCore& transforms) : transforms_(transforms) {}

  /// Takes effect with the next image.
  void setParameters(const LocationParameters& parameters);
  const LocationParameters& parameters() const { return parameters_; }

  /// Looks up the transforms needed for an image. Can be called repeatedly.
  CameraPlaces lookUp(const std_msgs::Header& header) const;

  /// Replaces what was not found by the newest that tf knows, if tf_fallback says so.
  void fallBack(const std_msgs::Header& header, CameraPlaces& places) const;

  /// Computes what is published for the planes. Ids restart if timestamps jump back, or forward by more
  /// than a minute.
  /// @param header  header of the image, its frame_id without a leading slash
  /// @param places  result of lookUp(), with the target found
  /// @return the published planes, valid until the next call
  const PublishedPlanes& locate(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                const std_msgs::Header& header, const CameraPlaces& places);

  /// Number of planes of the last image that are too many to be tracked.
  std::size_t untracked() const { return tracker_.untracked(); }

 private:
  static std::optional<Eigen::Isometry3d> poseIn(const std::string& frame, const TransformLookup& lookup);
  std::optional<Eigen::Isometry3d> motionTo(const CameraPlaces& places);
  bool isAnotherTime(const ros::Time& stamp) const;

  tf2::BufferCore& transforms_;
  LocationParameters parameters_;
  PlaneTracker tracker_;
  std::optional<ros::Time> last_stamp_;
  std::optional<Eigen::Isometry3d> last_pose_;  // camera pose in the fixed frame
  PublishedPlanes published_;
};

}  // namespace line_plane_segmentation
