// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <vector>

#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {

/// The topics of the results. A message is made only while somebody subscribes to its topic, published
/// as a shared pointer, so that subscribers in the same process get it without a copy, and not touched
/// afterwards. Nothing is latched: that would serialise every message.
///
/// wanted() and publish() may be called from any thread.
class Outputs {
 public:
  /// Advertises all topics.
  /// @param subscribers_changed  called on the node handle's queue whenever somebody comes or goes, perhaps
  ///                             before this constructor returns
  Outputs(ros::NodeHandle private_nh, const std::function<void()>& subscribers_changed);

  /// Somebody subscribes to any of them.
  bool wanted() const;

  /// Somebody subscribes to one that shows the planes' outlines.
  bool outlinesWanted() const;

  /// Somebody subscribes to the scanlines, which the segmenter makes only when it is asked.
  bool scanlinesWanted() const;

  /// Makes and publishes what is wanted, but for the scanlines.
  void publish(const SegmentedFrame& frame) const;

  void publishScanlines(const SegmentedFrame& frame, const std::vector<LineSegment>& segments,
                        const std::vector<PlaneCandidate>& candidates) const;

 private:
  ros::Publisher planes_;
  ros::Publisher labels_;
  ros::Publisher cloud_;
  ros::Publisher overlay_;
  ros::Publisher markers_;
  ros::Publisher scanlines_;
};

}  // namespace line_plane_segmentation
