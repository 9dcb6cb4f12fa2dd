// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_subscription.h"

#include <utility>

#include "log_exceptions.h"

namespace line_plane_segmentation {

CloudSubscription::CloudSubscription(const ros::NodeHandle& nh, int queue_size, Handler handler)
    : nh_(nh), queue_size_(static_cast<unsigned>(queue_size)), handler_(std::move(handler)) {
  topics_.cloud = nh.resolveName("depth/points");
}

void CloudSubscription::subscribe() {
  if (subscribed()) return;
  times_.subscribed = std::chrono::steady_clock::now();
  subscriber_ = nh_.subscribe(topics_.cloud, queue_size_, &CloudSubscription::onCloud, this,
                              ros::TransportHints().tcpNoDelay());
}

void CloudSubscription::unsubscribe() {
  subscriber_.shutdown();
  times_ = InputTimes{};
}

void CloudSubscription::onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  logExceptions(topics_.cloud, [&] {
    times_.frame = std::chrono::steady_clock::now();
    InputFrame frame;
    frame.cloud = cloud;
    handler_(std::move(frame));
  });
}

}  // namespace line_plane_segmentation
