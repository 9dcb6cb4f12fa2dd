// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/TrackedPlaneArray.h>
#include <ros/time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "conversions.h"
#include "line_plane_segmentation/plane_track_filter.h"
#include "line_plane_segmentation/plane_tracker.h"

namespace line_plane_segmentation {

/// Fuses the published planes of consecutive images by their ids, in the fixed frame: one PlaneTrackFilter
/// per id. Restarts if timestamps go back, if they jump forward by more than a minute, or if the fixed frame
/// changes. Not thread-safe.
class TrackedPlanes {
 public:
  /// Fuses the planes of an image, and returns all planes that are visible or kept.
  /// @param tracking  track_memory is the time for which an invisible plane is kept. If track_planes is
  /// false,
  ///         each image is a restart
  /// @return null if the camera's pose in the fixed frame is unknown
  TrackedPlaneArray::Ptr fuse(const SegmentedFrame& frame, const FusionParameters& parameters,
                              const TrackingParameters& tracking);

 private:
  struct Track {
    PlaneTrackFilter filter;
    TrackedPlane message;
  };

  void removeHidden(const ros::Time& stamp, double memory);
  void updateTrack(const SegmentedFrame& frame, const PublishedPlane& published, double seconds,
                   const CameraVelocity& velocity, const FusionParameters& parameters);

  std::map<std::uint32_t, Track> tracks_;  // by id
  std::string fixed_frame_;
  std::optional<ros::Time> last_stamp_;
  Eigen::Isometry3d last_pose_;  // of the camera in the fixed frame, with last_stamp_
};

}  // namespace line_plane_segmentation
