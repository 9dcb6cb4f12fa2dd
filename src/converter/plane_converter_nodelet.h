// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <nodelet/nodelet.h>
#include <ros/publisher.h>
#include <sensor_msgs/Image.h>

#include <memory>
#include <mutex>

#include "conversions_of_planes.h"

namespace line_plane_segmentation {

/// Converts a PlaneArray to messages of PCL, geometry_msgs and, where they are installed,
/// jsk_recognition_msgs. Subscribes to `planes` while one of its topics has a subscriber, to `labels` while
/// `~inliers` has one.
class PlaneConverterNodelet : public nodelet::Nodelet {
 private:
  void onInit() override;
  void start();
  void updateSubscriptions();
  template <typename Message>
  void subscribe(message_filters::Subscriber<Message>& subscriber, const char* topic, bool is_wanted);
  void convert(const PlaneArray::ConstPtr& planes);
  void publishInliers(const PlaneArray::ConstPtr& planes, const sensor_msgs::Image::ConstPtr& labels);

  // Held while the publishers are made and whenever subscriptions change.
  std::mutex connect_mutex_;
  bool is_ready_ = false;
  PlaneChoice choice_;
  ros::Publisher model_, inliers_, polygon_, markers_, jsk_polygons_, jsk_coefficients_;
  message_filters::Subscriber<PlaneArray> planes_;
  message_filters::Subscriber<sensor_msgs::Image> labels_;
  // Only while labels are subscribed to: planes without labels would fill it, and those of a later time would
  // displace all others after a jump back.
  std::unique_ptr<message_filters::TimeSynchronizer<PlaneArray, sensor_msgs::Image>> pairs_;
};

}  // namespace line_plane_segmentation
