// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <chrono>
#include <functional>
#include <string>

#include "stamp_pairing.h"

namespace line_plane_segmentation {

/// When something last came over a subscription. The default time_point: never.
struct InputTimes {
  using TimePoint = std::chrono::steady_clock::time_point;
  TimePoint subscribed;  ///< since when there is a subscription; never = there is none
  TimePoint image;
  TimePoint info;
  TimePoint frame;  ///< an image together with its camera_info
};

/// The subscription of a depth image and its sibling camera_info. All calls, and the handler, run on the
/// node handle's (single-threaded) queue or under the lock of whoever calls.
class CameraSubscription {
 public:
  using Handler = std::function<void(CameraFrame)>;

  /// Subscribes nothing yet.
  /// @param queue_size  messages that may wait, in the transport and for their other half
  /// @param handler     called with every pair, must return at once
  CameraSubscription(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, int queue_size,
                     Handler handler);

  void subscribe();
  void unsubscribe();
  bool subscribed() const { return subscribed_; }

  const std::string& imageTopic() const { return image_topic_; }
  const std::string& infoTopic() const { return info_topic_; }
  const InputTimes& times() const { return times_; }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image);
  void onInfo(const sensor_msgs::CameraInfoConstPtr& info);
  void deliver(CameraFrame frame);

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  image_transport::ImageTransport transport_;
  std::string image_topic_;
  std::string info_topic_;
  unsigned queue_size_;
  Handler handler_;
  StampPairing pairing_;
  InputTimes times_;
  bool subscribed_ = false;
  image_transport::Subscriber image_subscriber_;
  ros::Subscriber info_subscriber_;
};

}  // namespace line_plane_segmentation
