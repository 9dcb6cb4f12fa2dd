// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <string>

namespace line_plane_segmentation {

/// What tf answered.
struct TransformLookup {
  enum class Answer {
    kFound,
    kLate,     ///< not known yet for this time, only for earlier ones: it may come
    kUnknown,  ///< the frames are not known, or not how they hang together, at any time: a moment ago tf
               ///< began, or began again, or it never tells
    kMissing,  ///< not known, and waiting will not help
  };
  Answer answer = Answer::kMissing;
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();  ///< if found: source's points in `target`
  std::string problem;                                          ///< if not: tf's words

  bool found() const { return answer == Answer::kFound; }
};

/// Asks for a transform at a time; never waits for it. The time 0 stands for the newest there is, as ever in
/// tf. Never throws, whatever the frames' names are.
///
/// A buffer that holds nothing but transforms from long after the time is emptied: its clock has gone back, a
/// bag plays again from its start, and it would refuse all that comes until it is as late again as it was.
TransformLookup lookUp(tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                       const ros::Time& time);

}  // namespace line_plane_segmentation
