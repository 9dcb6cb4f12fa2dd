// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_subscription.h"

#include <utility>

#include "log_exceptions.h"

namespace line_plane_segmentation {

CloudSubscription::CloudSubscription(const ros::NodeHandle& nh, int queue_size, Handler handler)
    : nh_(nh), queue_size_(static_cast<unsigned>(queue_size)), handler_(std::move(handler)) {
  input_topics.cloud = nh.resolveName("depth/points");
}

void CloudSubscription::subscribe() {
  if (subscribed()) return;
  input_times.subscribed = std::chrono::steady_clock::now();
  subscriber_ = nh_.subscribe(input_topics.cloud, queue_size_, &CloudSubscription::onCloud, this,
                              ros::TransportHints().tcpNoDelay());
}

void CloudSubscription::unsubscribe() {
  subscriber_.shutdown();
  input_times = InputTimes{};
}

void CloudSubscription::onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  logExceptions(input_topics.cloud, [&] {
    input_times.frame = std::chrono::steady_clock::now();
    InputFrame frame;
    frame.cloud = cloud;
    handler_(std::move(frame));
  });
}

}  // namespace line_plane_segmentation
