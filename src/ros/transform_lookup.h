// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <chrono>
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
  bool is_too_old = false;            ///< the buffer holds nothing but transforms from long after the time

  bool found() const { return answer == Answer::kFound; }
};

/// Looks up a transform at a time, without waiting. Time 0 selects the newest one, as usual in tf. Never
/// throws, for any frame names.
TransformLookup lookUp(const tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                       const ros::Time& time);

/// Returns tf's words for a transform that was not found and, if it is late, by how much, and what helps.
/// @param patience  [s] that was waited for it
std::string explain(const TransformLookup& lookup, double patience);

/// Decides when tf's clock has gone back, because a bag plays again from its start: the buffer then has to be
/// emptied, since it refuses all that comes until it is as late again as it was. A few images with old stamps
/// are no reason.
class ClockJump {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param images    that are too old, one after another
  /// @param duration  for so long
  ClockJump(int images, std::chrono::steady_clock::duration duration)
      : images_(images), duration_(duration) {}

  /// Takes note of an image.
  /// @param is_too_old  as of the lookups of its transforms
  /// @return whether the clock has gone back
  bool add(bool is_too_old, TimePoint now);

 private:
  int images_;
  std::chrono::steady_clock::duration duration_;
  int count_ = 0;
  TimePoint since_;
};

}  // namespace line_plane_segmentation
