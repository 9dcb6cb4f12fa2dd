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

/// Time for timestamps and delays [s], from a clock shared by all processes of this machine.
inline double now() { return ros::SteadyTime::now().toSec(); }

/// Runs callbacks until `condition()` is true.
/// @return false if it was not true within the time [s]
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

/// Runs callbacks for this time [s].
inline void spinFor(double seconds) {
  waitUntil([] { return false; }, seconds);
}

/// Publishes depth image and camera_info like a camera driver.
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

  /// Publishes both with one timestamp.
  void publish(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info, const ros::Time& stamp) {
    publishImage(image, stamp);
    publishInfo(info, stamp);
  }

  unsigned imageSubscribers() const { return image_publisher_.getNumSubscribers(); }
  unsigned infoSubscribers() const { return info_publisher_.getNumSubscribers(); }

  /// Number of times that a subscriber of the image connected.
  int arrivals() const { return arrivals_; }

  bool waitForSubscriber() const {
    return waitUntil([this] { return imageSubscribers() == 1 && infoSubscribers() == 1; });
  }

  /// Waits until there is no subscriber.
  bool waitForIdle() const {
    return waitUntil([this] { return imageSubscribers() == 0 && infoSubscribers() == 0; });
  }

 private:
  int arrivals_ = 0;
  ros::NodeHandle nh_;
  ros::Publisher image_publisher_;
  ros::Publisher info_publisher_;
};

/// The newest message of a topic, and the number of messages.
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

  /// Waits for the message with this timestamp.
  bool waitFor(const ros::Time& stamp, double seconds = 15.0) const {
    return waitUntil([&] { return newest_ && newest_->header.stamp == stamp; }, seconds);
  }

 private:
  ros::Subscriber subscriber_;
  boost::shared_ptr<const Message> newest_;
  int count_ = 0;
};

}  // namespace line_plane_segmentation
