// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <mutex>

namespace line_plane_segmentation {

/// Listens to tf while somebody subscribes to the results and the results need it: on a robot tf comes a
/// thousand times a second. A thread of its own takes it in. Thread-safe.
class TransformFeed {
 public:
  explicit TransformFeed(const ros::NodeHandle& nh) : nh_(nh) {}

  /// Somebody subscribes to the results.
  void setWanted(bool wanted);

  /// The results are to be told in, or by, other frames than the camera's.
  void setNeeded(bool needed);

  tf2::BufferCore& buffer() { return buffer_; }

 private:
  void update();

  ros::NodeHandle nh_;
  tf2::BufferCore buffer_;
  std::mutex mutex_;
  bool wanted_ = false;
  bool needed_ = false;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
};

}  // namespace line_plane_segmentation
