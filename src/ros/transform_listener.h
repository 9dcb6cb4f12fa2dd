// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_listener.h>

#include <chrono>
#include <memory>
#include <mutex>

#include "transform_lookup.h"

namespace line_plane_segmentation {

/// Listens to tf, in a thread of its own, while a frame is set. It does so also without subscribers: a
/// connection to tf takes some tenths of a second, so the first images after it would have no transforms.
/// When the clock of tf goes back, because a bag loops, it empties the buffer, which otherwise would refuse
/// all transforms until they are as late again. Thread-safe.
class TransformListener {
 public:
  explicit TransformListener(const ros::NodeHandle& nh) : nh_(nh) {}

  /// Starts or ends listening.
  /// @param needed  whether the results depend on any frame other than the camera's
  void setNeeded(bool needed);

  /// Whether it has listened for less than a second: static transforms, which are latched, may still be on
  /// their way.
  bool isNew() const;

  tf2::BufferCore& buffer() { return buffer_; }

 private:
  void watch(const tf2_msgs::TFMessage& message);

  ros::NodeHandle nh_;
  tf2::BufferCore buffer_;
  mutable std::mutex mutex_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  ros::Subscriber watcher_;
  ClockWatch clock_;
  std::chrono::steady_clock::time_point started_;
};

}  // namespace line_plane_segmentation
