// SPDX-License-Identifier: BSD-3-Clause
#include "depth_topics.h"

#include <sensor_msgs/image_encodings.h>

#include <algorithm>

namespace line_plane_segmentation {
namespace {

constexpr char kImageType[] = "sensor_msgs/Image";
constexpr char kInfoType[] = "sensor_msgs/CameraInfo";
constexpr std::size_t kWaitingImages = 10;  // the nodelet's default queue_size

// "/camera/depth" of "/camera/depth/image_raw", "" of "/image".
std::string parentOf(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string::npos ? std::string() : topic.substr(0, slash);
}

// A label image of this tool or of the nodelet: 16UC1 as well, but no depth.
bool isLabelsTopic(const std::string& topic) {
  const std::string end = "/plane_segmenter/labels";
  return topic.size() >= end.size() && topic.compare(topic.size() - end.size(), end.size(), end) == 0;
}

bool isDepthEncoding(const std::string& encoding) {
  namespace enc = sensor_msgs::image_encodings;
  return encoding == enc::TYPE_16UC1 || encoding == enc::TYPE_32FC1;
}

}  // namespace

std::string infoTopicOf(const std::string& image_topic) { return parentOf(image_topic) + "/camera_info"; }

std::string resultNamespaceOf(const std::string& image_topic) {
  return parentOf(parentOf(image_topic)) + "/plane_segmenter";
}

bool DepthTopics::wants(const std::string& topic, const std::string& datatype) const {
  if (datatype != kImageType && datatype != kInfoType) return false;
  return named_.empty() || std::any_of(named_.begin(), named_.end(), [&](const std::string& name) {
           return topic == (datatype == kImageType ? name : infoTopicOf(name));
         });
}

void DepthTopics::add(const BagMessage& message, std::deque<BagFrame>& frames) {
  const std::string& type = message.content->getDataType();
  if (!wants(message.topic, type)) return;
  if (type == kImageType) {
    addImage(message, frames);
  } else {
    addInfo(message, frames);
  }
}

void DepthTopics::addImage(const BagMessage& message, std::deque<BagFrame>& frames) {
  const auto known = by_image_.find(message.topic);
  if (known != by_image_.end() && known->second == nullptr) return;
  const sensor_msgs::ImageConstPtr image = message.content->instantiate<sensor_msgs::Image>();
  DepthTopic* const topic = findOrPick(message.topic, image->encoding);
  if (topic == nullptr) return;
  ++topic->images;
  BagFrame frame{topic, {}, message.time};
  if (topic->pairing.add(image, frame.messages)) frames.push_back(frame);
}

void DepthTopics::addInfo(const BagMessage& message, std::deque<BagFrame>& frames) {
  const sensor_msgs::CameraInfoConstPtr info = message.content->instantiate<sensor_msgs::CameraInfo>();
  std::deque<sensor_msgs::CameraInfoConstPtr>& early = early_infos_[message.topic];
  early.push_back(info);
  if (early.size() > StampPairing::kMaxInfos) early.pop_front();
  for (DepthTopic& topic : topics_) {
    if (topic.info != message.topic) continue;
    BagFrame frame{&topic, {}, message.time};
    if (topic.pairing.add(info, frame.messages)) frames.push_back(frame);
  }
}

DepthTopic* DepthTopics::findOrPick(const std::string& topic, const std::string& encoding) {
  const auto known = by_image_.find(topic);
  if (known != by_image_.end()) return known->second;
  if (named_.empty() && (!isDepthEncoding(encoding) || isLabelsTopic(topic))) {
    others_.insert(topic + " (" + encoding + ")");
    return by_image_[topic] = nullptr;
  }
  std::string result_namespace = resultNamespaceOf(topic);
  const bool taken = std::any_of(topics_.begin(), topics_.end(), [&](const DepthTopic& other) {
    return other.result_namespace == result_namespace;
  });
  if (taken) result_namespace = topic + "/plane_segmenter";
  topics_.push_back(
      {topic, infoTopicOf(topic), result_namespace, StampPairing(kWaitingImages), 0, 0, 0, 0, {}});
  // What came before the first image is not lost for it.
  CameraFrame none;
  for (const auto& info : early_infos_[topics_.back().info]) topics_.back().pairing.add(info, none);
  return by_image_[topic] = &topics_.back();
}

}  // namespace line_plane_segmentation
