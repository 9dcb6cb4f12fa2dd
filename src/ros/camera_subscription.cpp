// SPDX-License-Identifier: BSD-3-Clause
#include "camera_subscription.h"

#include <image_transport/camera_common.h>
#include <ros/console.h>
#include <ros/master.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "compressed_depth.h"
#include "log_exceptions.h"

namespace line_plane_segmentation {
namespace {

constexpr char kCompressedDepth[] = "compressedDepth";
// Largest delay of images relative to their camera_info, for example over a slow network.
constexpr std::chrono::seconds kInfoSpan(10);
constexpr unsigned kInfoQueue = 1000;

// Returns the camera_info topic beside the image topic, unless depth/camera_info or that topic is remapped.
std::string infoTopicFor(const ros::NodeHandle& nh, const std::string& image_topic) {
  const std::string own_name = "depth/camera_info";
  const std::string remapped = nh.resolveName(own_name);
  if (remapped != nh.resolveName(own_name, false)) return remapped;
  return nh.resolveName(image_transport::getCameraInfoTopic(image_topic));
}

bool hasPlugin(const image_transport::ImageTransport& transport, const std::string& name) {
  const std::vector<std::string> loadable = transport.getLoadableTransports();
  return std::find(loadable.begin(), loadable.end(), "image_transport/" + name) != loadable.end();
}

// Lists the other camera_info topics for a warning: " (there is /a, /b)".
std::string otherInfoTopics(const std::string& but) {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return {};
  std::string list;
  for (const ros::master::TopicInfo& topic : topics) {
    if (topic.datatype != "sensor_msgs/CameraInfo" || topic.name == but) continue;
    list += (list.empty() ? " (there is " : ", ") + topic.name;
  }
  return list.empty() ? list : list + ")";
}

}  // namespace

CameraSubscription::CameraSubscription(const std::string& name, const ros::NodeHandle& nh,
                                       const ros::NodeHandle& private_nh, const StartParameters& parameters,
                                       Handler handler)
    : name_(name),
      nh_(nh),
      private_nh_(private_nh),
      transport_(nh),
      queue_size_(static_cast<unsigned>(parameters.queue_size)),
      handler_(std::move(handler)),
      infos_(kInfoSpan, kInfoQueue * static_cast<unsigned>(kInfoSpan.count())),
      matcher_(parameters.info_matching, queue_size_) {
  topics_.image = nh.resolveName("depth/image_rect");
  topics_.info = infoTopicFor(nh, topics_.image);
  needs_rectification_ = needsRectification(parameters.rectify, topics_.image);
}

void CameraSubscription::subscribe() {
  if (subscribed()) return;
  times_.subscribed = std::chrono::steady_clock::now();
  unmatched_since_ = {};
  info_subscriber_ = nh_.subscribe(topics_.info, kInfoQueue, &CameraSubscription::onInfo, this,
                                   ros::TransportHints().tcpNoDelay());
  subscribeImages();
  timer_ = nh_.createWallTimer(ros::WallDuration(0.25), [this](const ros::WallTimerEvent&) {
    logExceptions(name_, [this] { onTimer(); });
  });
}

void CameraSubscription::subscribeImages() {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  const image_transport::TransportHints hints("raw", no_delay, private_nh_);
  if (hints.getTransport() == kCompressedDepth && !hasPlugin(transport_, kCompressedDepth)) {
    compressed_subscriber_ = nh_.subscribe(topics_.image + "/" + kCompressedDepth, queue_size_,
                                           &CameraSubscription::onCompressed, this, no_delay);
    return;
  }
  const auto on_image = [this](const sensor_msgs::ImageConstPtr& image) {
    logExceptions(topics_.image, [&] { onImage({image}); });
  };
  image_subscriber_ = transport_.subscribe(topics_.image, queue_size_, on_image, ros::VoidPtr(), hints);
}

void CameraSubscription::unsubscribe() {
  timer_.stop();
  image_subscriber_.shutdown();
  compressed_subscriber_.shutdown();
  info_subscriber_.shutdown();
  matcher_.clear();
  infos_.clearStamps();
  times_ = InputTimes{};
}

void CameraSubscription::onCompressed(const sensor_msgs::CompressedImageConstPtr& compressed) {
  logExceptions(topics_.image, [&] {
    const sensor_msgs::ImageConstPtr image = describeCompressedDepth(*compressed);
    if (image) {
      onImage({image, compressed});
    } else {
      ROS_WARN_THROTTLE(5.0, "[%s] %s/%s does not hold compressed depth images: its format is '%.64s'",
                        name_.c_str(), topics_.image.c_str(), kCompressedDepth, compressed->format.c_str());
    }
  });
}

void CameraSubscription::onImage(const DepthMessage& image) {
  times_.image = std::chrono::steady_clock::now();
  if (unmatched_since_ == InputTimes::TimePoint{}) unmatched_since_ = times_.image;
  InfoMatcher::Frames frames;
  matcher_.addImage(image, infos_, times_.image, frames);
  deliver(frames);
}

void CameraSubscription::onInfo(const sensor_msgs::CameraInfoConstPtr& info) {
  logExceptions(topics_.info, [&] {
    times_.info = std::chrono::steady_clock::now();
    infos_.add(info, times_.info);
    InfoMatcher::Frames frames;
    matcher_.addInfo(info->header.stamp, infos_, frames);
    deliver(frames);
  });
}

void CameraSubscription::onTimer() {
  const InputTimes::TimePoint now = std::chrono::steady_clock::now();
  InfoMatcher::Frames frames;
  matcher_.poll(infos_, now, frames);
  deliver(frames);
  warnAboutMissingInfo(now);
}

void CameraSubscription::deliver(InfoMatcher::Frames& frames) {
  times_.has_fallen_back = matcher_.hasFallenBack();
  if (times_.has_fallen_back && !std::exchange(warned_of_fallback_, true)) {
    ROS_WARN(
        "[%s] no camera_info on %s has the stamp of an image on %s: from now on each image goes with the "
        "newest "
        "one of its frame and size. ~info_matching: exact forbids that, latest does it without this warning",
        name_.c_str(), topics_.info.c_str(), topics_.image.c_str());
  }
  if (frames.empty()) return;
  times_.frame = std::chrono::steady_clock::now();
  unmatched_since_ = {};
  warned_of_missing_info_ = false;
  for (InputFrame& frame : frames) {
    frame.needs_rectification = needs_rectification_;
    handler_(std::move(frame));
  }
}

void CameraSubscription::warnAboutMissingInfo(InputTimes::TimePoint now) {
  constexpr std::chrono::seconds kPatience(3);
  if (unmatched_since_ == InputTimes::TimePoint{} || now - unmatched_since_ < kPatience) return;
  if (std::exchange(warned_of_missing_info_, true)) return;
  const bool has_infos = now - times_.info < kPatience;
  ROS_WARN("[%s] images come on %s, but %s on %s%s: remap depth/camera_info to the right topic%s",
           name_.c_str(), topics_.image.c_str(),
           has_infos ? "no camera_info that fits them" : "no camera_info", topics_.info.c_str(),
           otherInfoTopics(topics_.info).c_str(), has_infos ? ", or set ~info_matching to latest" : "");
}

}  // namespace line_plane_segmentation
