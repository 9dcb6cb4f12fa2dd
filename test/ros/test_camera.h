// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "test_messages.h"

namespace line_plane_segmentation {

/// A time for stamps and delays [s], of a clock that all processes of this machine share.
inline double now() { return ros::SteadyTime::now().toSec(); }

/// Lets callbacks run until `condition()` holds.
/// @return whether it came to hold before the time [s] was up
template <typename Condition>
bool waitUntil(Condition condition, double seconds = 15.0) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (ros::ok() && std::chrono::steady_clock::now() < end) {
    ros::spinOnce();
    if (condition()) return true;
    ros::WallDuration(0.005).sleep();
  }
  return false;
}

/// Lets callbacks run for so long [s].
inline void spinFor(double seconds) {
  waitUntil([] { return false; }, seconds);
}

/// Publishes what a test makes of a depth camera's topics.
class TestCamera {
 public:
  /// @param name_space  of its topics
  /// @param queue_size  messages that may wait for a slow subscriber
  explicit TestCamera(const std::string& name_space = "", std::uint32_t queue_size = 10)
      : nh_(name_space),
        image_publisher_(nh_.advertise<sensor_msgs::Image>(
            "depth/image_rect", queue_size, [this](const ros::SingleSubscriberPublisher&) { ++arrivals_; })),
        info_publisher_(nh_.advertise<sensor_msgs::CameraInfo>("depth/camera_info", queue_size)) {}
  TestCamera(const TestCamera&) = delete;
  TestCamera& operator=(const TestCamera&) = delete;

  void publishImage(sensor_msgs::Image image, const ros::Time& stamp) {
    image.header.stamp = stamp;
    image_publisher_.publish(image);
  }

  void publishInfo(sensor_msgs::CameraInfo info, const ros::Time& stamp) {
    info.header.stamp = stamp;
    info_publisher_.publish(info);
  }

  /// Publishes both under one stamp.
  void publish(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info, const ros::Time& stamp) {
    publishImage(image, stamp);
    publishInfo(info, stamp);
  }

  unsigned imageSubscribers() const { return image_publisher_.getNumSubscribers(); }
  unsigned infoSubscribers() const { return info_publisher_.getNumSubscribers(); }

  /// How often somebody subscribed to the image.
  int arrivals() const { return arrivals_; }

  bool waitForSubscriber() const {
    return waitUntil([this] { return imageSubscribers() == 1 && infoSubscribers() == 1; });
  }

  /// Waits until nobody listens.
  bool waitForIdle() const {
    return waitUntil([this] { return imageSubscribers() == 0 && infoSubscribers() == 0; });
  }

 private:
  int arrivals_ = 0;
  ros::NodeHandle nh_;
  ros::Publisher image_publisher_;
  ros::Publisher info_publisher_;
};

/// The newest message of a topic, and how many came.
template <typename Message>
class Inbox {
 public:
  explicit Inbox(const std::string& topic) {
    ros::NodeHandle nh;
    subscriber_ = nh.subscribe<Message>(topic, 100, [this](const boost::shared_ptr<const Message>& message) {
      newest_ = message;
      ++count_;
    });
  }

  const boost::shared_ptr<const Message>& newest() const { return newest_; }
  int count() const { return count_; }

  /// Waits for the answer to the image of this stamp.
  bool waitFor(const ros::Time& stamp, double seconds = 15.0) const {
    return waitUntil([&] { return newest_ && newest_->header.stamp == stamp; }, seconds);
  }

 private:
  ros::Subscriber subscriber_;
  boost::shared_ptr<const Message> newest_;
  int count_ = 0;
};

}  // namespace line_plane_segmentation
