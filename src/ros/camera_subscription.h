// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>

#include <string>

#include "info_matcher.h"
#include "input_source.h"
#include "start_parameters.h"

namespace line_plane_segmentation {

/// Subscription of a depth image and its camera_info, which are paired by InfoMatcher.
class CameraSubscription : public InputSource {
 public:
  /// Resolves the topics; subscribe() starts the subscription.
  /// @param name     name of the nodelet, for the log
  /// @param handler  called with each pair
  CameraSubscription(const std::string& name, const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                     const StartParameters& parameters, Handler handler);

  void subscribe() override;
  void unsubscribe() override;
  std::uint64_t lostImages() const override { return matcher_.lostImages(); }
  std::uint64_t lateInfos() const override { return matcher_.lateInfos(); }

 private:
  void subscribeImages();
  void onImage(const DepthMessage& image);
  void onCompressed(const sensor_msgs::CompressedImageConstPtr& compressed);
  void onInfo(const sensor_msgs::CameraInfoConstPtr& info);
  void onTimer();
  void deliver(InfoMatcher::Frames& frames);
  void warnAboutMissingInfo(InputTimes::TimePoint now);

  std::string name_;
  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  image_transport::ImageTransport transport_;
  unsigned queue_size_;
  Handler handler_;
  bool needs_rectification_;
  InfoHistory infos_;
  InfoMatcher matcher_;
  image_transport::Subscriber image_subscriber_;
  ros::Subscriber compressed_subscriber_;
  ros::Subscriber info_subscriber_;
  ros::WallTimer timer_;
  InputTimes::TimePoint unmatched_since_;  // arrival of the first image since the last pair
  bool warned_of_fallback_ = false;
  bool warned_of_missing_info_ = false;
};

}  // namespace line_plane_segmentation
