// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <vector>

#include "conversions.h"
#include "robot_messages.h"

namespace line_plane_segmentation {

/// Publishers of the results. A message is built only while its topic has a subscriber. It is published as
/// a shared pointer, so that subscribers in the same process receive it without a copy, and never modified
/// afterwards. No topic is latched, since latching serialises every message.
///
/// subscribed() and publish() may be called from any thread.
class Outputs {
 public:
  /// Advertises all topics.
  /// @param queue_size  of small messages: all images that wait for a camera_info can be processed at once
  /// @param subscribers_changed  called on the node handle's queue when a subscriber connects or
  ///         disconnects, possibly before this constructor returns
  Outputs(ros::NodeHandle private_nh, unsigned queue_size, const std::function<void()>& subscribers_changed);

  /// Returns true if any output has a subscriber.
  bool subscribed() const;

  /// Returns true if an output that contains outlines has a subscriber.
  bool needsOutlines() const;

  /// Returns true if ~scanlines has a subscriber. The segmenter computes them on demand only.
  bool needsScanlines() const;

  /// Builds and publishes all outputs with subscribers, except the scanlines.
  /// @param robot  builds the clouds and messages of obstacles, objects and tracked planes
  void publish(const SegmentedFrame& frame, RobotMessages& robot) const;

  void publishScanlines(const SegmentedFrame& frame, const std::vector<LineSegment>& segments,
                        const std::vector<PlaneCandidate>& candidates) const;

 private:
  ros::Publisher planes_;
  ros::Publisher labels_;
  ros::Publisher cloud_;
  ros::Publisher overlay_;
  ros::Publisher markers_;
  ros::Publisher scanlines_;
  ros::Publisher cloud_without_planes_;
  ros::Publisher objects_;
  ros::Publisher tracked_planes_;
};

}  // namespace line_plane_segmentation
