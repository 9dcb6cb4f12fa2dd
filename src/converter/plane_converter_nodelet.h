// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>
#include <nodelet/nodelet.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <sensor_msgs/Image.h>

#include <deque>
#include <mutex>
#include <vector>

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
  void convert(const PlaneArray::ConstPtr& planes);
  void pairPlanes(const PlaneArray::ConstPtr& planes);
  void pairLabels(const sensor_msgs::Image::ConstPtr& labels);
  void publishInliers(const PlaneArray& planes, const sensor_msgs::Image& labels) const;

  // Held while the publishers are made and whenever subscriptions change.
  std::mutex connect_mutex_;
  bool is_ready_ = false;
  PlaneChoice choice_;
  ros::Publisher model_, inliers_, polygon_, markers_, jsk_polygons_, jsk_coefficients_;
  ros::Subscriber planes_, labels_;

  // The newest messages that wait for one with the same stamp. Used by the node handle's queue alone.
  std::deque<PlaneArray::ConstPtr> waiting_planes_;
  std::deque<sensor_msgs::Image::ConstPtr> waiting_labels_;
};

}  // namespace line_plane_segmentation
