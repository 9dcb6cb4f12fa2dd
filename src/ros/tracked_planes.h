// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/TrackedPlaneArray.h>
#include <ros/time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "line_plane_segmentation/plane_track_filter.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {

/// Fuses the published planes of successive images, by their ids, in the fixed frame. Forgets everything when
/// stamps go back or the fixed frame changes. Not thread-safe.
class TrackedPlanes {
 public:
  /// Fuses an image and describes all planes that are visible or remembered.
  /// @param tracking  how long a plane is remembered which is not visible. Without tracking nothing is fused
  /// @return null if the camera's pose in the fixed frame is unknown
  TrackedPlaneArray::Ptr fuse(const SegmentedFrame& frame, const FusionParameters& parameters,
                              const TrackingParameters& tracking);

 private:
  struct Track {
    PlaneTrackFilter filter;
    TrackedPlane message;
  };

  void forget(const ros::Time& stamp, double memory);
  void observe(const SegmentedFrame& frame, const PublishedPlane& published, double seconds,
               const FusionParameters& parameters);

  std::map<std::uint32_t, Track> tracks_;  // by id
  std::string fixed_frame_;
  std::optional<ros::Time> last_stamp_;
};

}  // namespace line_plane_segmentation
