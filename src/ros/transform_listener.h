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

/// Listener of tf that is active only while a frame parameter is set. It does not depend on subscribers of
/// the outputs, because a connection to tf takes some tenths of a second, during which images would have no
/// transforms. If the clock of tf jumps back because a bag loops, the buffer is cleared; otherwise it would
/// ignore all transforms up to the old time. Thread-safe.
class TransformListener {
 public:
  explicit TransformListener(const ros::NodeHandle& nh) : nh_(nh) {}

  /// Starts or stops the listener.
  /// @param needed  true if the results depend on a frame other than the camera's
  void setNeeded(bool needed);

  /// Returns true in the first second after the start, in which latched static transforms may not have
  /// arrived.
  bool isConnecting() const;

  tf2::BufferCore& buffer() { return buffer_; }

 private:
  void onTransforms(const tf2_msgs::TFMessage& message);

  ros::NodeHandle nh_;
  tf2::BufferCore buffer_;
  mutable std::mutex mutex_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  ros::Subscriber jump_subscriber_;
  ClockJumpDetector jump_detector_;
  std::chrono::steady_clock::time_point started_;
};

}  // namespace line_plane_segmentation
