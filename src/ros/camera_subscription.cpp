// SPDX-License-Identifier: BSD-3-Clause
#include "camera_subscription.h"

#include <image_transport/camera_common.h>

#include <utility>

#include "contain_exceptions.h"

namespace line_plane_segmentation {

CameraSubscription::CameraSubscription(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                       int queue_size, Handler handler)
    : nh_(nh),
      private_nh_(private_nh),
      transport_(nh),
      queue_size_(static_cast<unsigned>(queue_size)),
      handler_(std::move(handler)),
      pairing_(queue_size_) {
  topics_.image = nh.resolveName("depth/image_rect");
  topics_.info = nh.resolveName(image_transport::getCameraInfoTopic(topics_.image));
}

void CameraSubscription::subscribe() {
  if (subscribed()) return;
  times_.subscribed = std::chrono::steady_clock::now();
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  const image_transport::TransportHints hints("raw", no_delay, private_nh_);
  info_subscriber_ = nh_.subscribe(topics_.info, queue_size_, &CameraSubscription::onInfo, this, no_delay);
  image_subscriber_ =
      transport_.subscribe(topics_.image, queue_size_, &CameraSubscription::onImage, this, hints);
}

void CameraSubscription::unsubscribe() {
  image_subscriber_.shutdown();
  info_subscriber_.shutdown();
  pairing_.clear();
  times_ = InputTimes{};
}

void CameraSubscription::onImage(const sensor_msgs::ImageConstPtr& image) {
  containExceptions(topics_.image, [&] {
    times_.image = std::chrono::steady_clock::now();
    CameraFrame frame;
    if (pairing_.add(image, frame)) deliver(std::move(frame));
  });
}

void CameraSubscription::onInfo(const sensor_msgs::CameraInfoConstPtr& info) {
  containExceptions(topics_.info, [&] {
    times_.info = std::chrono::steady_clock::now();
    CameraFrame frame;
    if (pairing_.add(info, frame)) deliver(std::move(frame));
  });
}

void CameraSubscription::deliver(CameraFrame frame) {
  times_.frame = std::chrono::steady_clock::now();
  handler_(std::move(frame));
}

}  // namespace line_plane_segmentation
