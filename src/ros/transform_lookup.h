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
  enum class Answer {
    kFound,
    kLate,     ///< not yet available at this time, only at earlier ones: may arrive
    kUnknown,  ///< a frame or their connection is unknown at any time: tf has just
               ///< (re)started, or the frame does not exist
    kMissing,  ///< not available, and waiting does not help
  };
  Answer answer = Answer::kMissing;
  Eigen::Isometry3d transform =
      Eigen::Isometry3d::Identity();  ///< if found: maps points of `source` to `target`
  std::string problem;                ///< if not found: message of tf
  double missed_by = 0.0;             ///< [s] if kLate: how much older the newest transform is

  bool found() const { return answer == Answer::kFound; }
};

/// Looks up a transform at a time, without waiting. Time 0 selects the newest one, as usual in tf. Never
/// throws, for any frame names.
TransformLookup lookUp(const tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                       const ros::Time& time);

/// Returns tf's words for a transform that was not found and, if it is late, by how much, and what helps.
/// @param patience  [s] that was waited for it
std::string explain(const TransformLookup& lookup, double patience);

/// Detects that tf's clock has gone back, because a bag plays again from its start: the stamps of one frame
/// fall by more than the buffer holds. A publisher that is always late, or an image with an old stamp, is no
/// such jump.
class ClockWatch {
 public:
  /// Takes note of a transform.
  /// @param child  its child frame
  /// @return whether the clock has gone back; the frames are then forgotten
  bool wentBack(const std::string& child, const ros::Time& stamp);

 private:
  std::map<std::string, ros::Time> newest_;  // per child frame
};

}  // namespace line_plane_segmentation
