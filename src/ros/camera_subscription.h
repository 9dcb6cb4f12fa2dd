// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "input_source.h"
#include "stamp_pairing.h"

namespace line_plane_segmentation {

/// The subscription of a depth image and its sibling camera_info.
class CameraSubscription : public InputSource {
 public:
  /// Subscribes nothing yet.
  /// @param queue_size  messages that may wait in the transport, and images that may wait for their
  /// camera_info
  CameraSubscription(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, int queue_size,
                     Handler handler);

  void subscribe() override;
  void unsubscribe() override;
  std::uint64_t lostImages() const override { return pairing_.lostImages(); }
  std::uint64_t lateInfos() const override { return pairing_.lateInfos(); }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image);
  void onInfo(const sensor_msgs::CameraInfoConstPtr& info);
  void deliver(CameraFrame frame);

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  image_transport::ImageTransport transport_;
  unsigned queue_size_;
  Handler handler_;
  StampPairing pairing_;
  image_transport::Subscriber image_subscriber_;
  ros::Subscriber info_subscriber_;
};

}  // namespace line_plane_segmentation
