// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "line_plane_segmentation/ros/location_parameters.h"
#include "line_plane_segmentation/ros/published_planes.h"
#include "line_plane_segmentation/segmentation.h"
#include "transform_lookup.h"

namespace line_plane_segmentation {

/// What tf knows of an image's camera. Lookups that nobody asked for are found, and mean nothing.
struct CameraPlaces {
  TransformLookup target;
  TransformLookup gravity;
  TransformLookup fixed;

  static constexpr std::size_t kCount = 3;
  std::array<const TransformLookup*, kCount> all() const { return {&target, &gravity, &fixed}; }

  /// Whether that is the answer to any of the lookups.
  bool has(TransformLookup::Answer answer) const;

  /// Whether any of them is too old for tf.
  bool isTooOld() const;
};

/// Tells where the planes of one image after the other are, how they lie, and which of those before they are.
/// Never waits for tf. Not thread-safe.
class PlaneLocator {
 public:
  /// @param transforms  must outlive this
  explicit PlaneLocator(tf2::BufferCore& transforms) : transforms_(transforms) {}

  /// Takes effect with the next image.
  void setParameters(const LocationParameters& parameters);
  const LocationParameters& parameters() const { return parameters_; }

  /// Asks tf what is needed for an image, as often as one likes.
  CameraPlaces lookUp(const std_msgs::Header& header) const;

  /// Replaces what was not found by the newest that tf knows, if tf_fallback says so.
  void fallBack(const std_msgs::Header& header, CameraPlaces& places) const;

  /// Empties tf if its clock has gone back.
  /// @param jump  what counts as that; once for each image
  /// @return whether it was emptied
  bool clearIfClockWentBack(const CameraPlaces& places, ClockJump& jump);

  /// Ids start anew when stamps go back, or ahead by more than a minute.
  /// @param header  the image's, its frame_id without a leading slash
  /// @param places  as lookUp() told, with a target
  /// @return what is to be published; valid until the next call
  const PublishedPlanes& locate(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                const std_msgs::Header& header, const CameraPlaces& places);

 private:
  std::optional<Eigen::Isometry3d> motionTo(const CameraPlaces& places);
  bool isAnotherTime(const ros::Time& stamp) const;

  tf2::BufferCore& transforms_;
  LocationParameters parameters_;
  PlaneTracker tracker_;
  std::optional<ros::Time> last_stamp_;
  std::optional<Eigen::Isometry3d> last_pose_;  // of the camera in the fixed frame
  PublishedPlanes published_;
};

}  // namespace line_plane_segmentation
