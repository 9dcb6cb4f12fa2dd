// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "input_source.h"

namespace line_plane_segmentation {

/// Subscription of an organised point cloud, for sensors without a depth image.
class CloudSubscription : public InputSource {
 public:
  /// Resolves the topic; subscribe() starts the subscription.
  /// @param queue_size  largest number of messages waiting in the transport
  CloudSubscription(const ros::NodeHandle& nh, int queue_size, Handler handler);

  void subscribe() override;
  void unsubscribe() override;

 private:
  void onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);

  ros::NodeHandle nh_;
  unsigned queue_size_;
  Handler handler_;
  ros::Subscriber subscriber_;
};

}  // namespace line_plane_segmentation
