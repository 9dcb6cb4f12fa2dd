// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <map>
#include <string>

namespace line_plane_segmentation {

/// Result of a tf lookup.
struct TransformLookup {
  enum class Status {
    kFound,
    kLate,     ///< only available at earlier times; may arrive later
    kUnknown,  ///< a frame or their connection is unknown at any time: tf has just
               ///< (re)started, or the frame does not exist
    kMissing,  ///< not available, and waiting does not help
  };
  Status status = Status::kMissing;
  Eigen::Isometry3d transform =
      Eigen::Isometry3d::Identity();  ///< if found: maps points of `source` to `target`
  std::string problem;                ///< if not found: message of tf
  double missed_by = 0.0;  ///< [s] if kLate: age of the newest transform relative to the requested time

  bool found() const { return status == Status::kFound; }
};

/// Looks up a transform at a time, without waiting. Time 0 selects the newest one, as usual in tf. Never
/// throws, for any frame names.
TransformLookup lookUp(const tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                       const ros::Time& time);

/// Returns tf's error message of a transform that was not found; if it is late, also its age and the
/// parameters to change.
/// @param patience  [s] time that the transform was waited for
std::string explain(const TransformLookup& lookup, double patience);

/// Detects that the clock of tf has jumped back, because a bag loops: the timestamps of one child frame
/// decrease by more than the duration of tf's buffer. Publishers with constant delay and single images with
/// old timestamps are not such jumps.
class ClockJumpDetector {
 public:
  /// Processes the timestamp of a transform.
  /// @param child  child frame of the transform
  /// @return true if the clock has jumped back; the stored timestamps are then cleared
  bool jumpedBack(const std::string& child, const ros::Time& stamp);

 private:
  std::map<std::string, ros::Time> newest_;  // newest timestamp per child frame
};

}  // namespace line_plane_segmentation
