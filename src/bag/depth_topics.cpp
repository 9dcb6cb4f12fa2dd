// SPDX-License-Identifier: BSD-3-Clause
#include "depth_topics.h"

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/make_shared.hpp>

#include "camera_info_message.h"
#include "compressed_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr char kImageType[] = "sensor_msgs/Image";
constexpr char kCompressedType[] = "sensor_msgs/CompressedImage";
constexpr char kInfoType[] = "sensor_msgs/CameraInfo";
constexpr std::size_t kWaiting = 32;  // images; more than one second of them

// "/camera/depth" of "/camera/depth/image_raw", "" of "/image".
std::string parentOf(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string::npos ? std::string() : topic.substr(0, slash);
}

// Returns true for label images of this tool or of the nodelet, which are 16UC1, but not depth.
bool isLabelsTopic(const std::string& topic) {
  const std::string end = "/plane_segmenter/labels";
  return topic.size() >= end.size() && topic.compare(topic.size() - end.size(), end.size(), end) == 0;
}

bool isDepthEncoding(const std::string& topic, const std::string& encoding) {
  namespace enc = sensor_msgs::image_encodings;
  if (encoding == enc::TYPE_16UC1 || encoding == enc::TYPE_32FC1) return true;
  return encoding == enc::MONO16 && boost::algorithm::to_lower_copy(topic).find("depth") != std::string::npos;
}

// Returns the raw topic of a compressed one, and any other topic unchanged.
std::string imageTopicOf(const std::string& topic, const std::string& datatype) {
  return datatype == kCompressedType ? rawTopicOf(topic) : topic;
}

// RealSense's viewer records the camera_info of ".../Depth_0/image/data" here.
std::string viewerInfoTopicOf(const std::string& image_topic) {
  return parentOf(parentOf(image_topic)) + "/info/camera_info";
}

bool isInfoTopicOf(const std::string& image_topic, const std::string& topic) {
  return topic == infoTopicOf(image_topic) || topic == viewerInfoTopicOf(image_topic);
}

}  // namespace

std::string infoTopicOf(const std::string& image_topic) { return parentOf(image_topic) + "/camera_info"; }

std::string resultNamespaceOf(const std::string& image_topic) {
  return parentOf(parentOf(image_topic)) + "/plane_segmenter";
}

bool DepthTopics::wants(const std::string& topic, const std::string& datatype) const {
  if (datatype == kInfoType) return !choice_.camera;
  if (datatype == kImageType) return choice_.images.empty() || isNamed(topic);
  if (datatype != kCompressedType) return false;
  const std::string raw = rawTopicOf(topic);
  // If a bag has both topics, the images are the same.
  return !raw.empty() && types_.count(raw) == 0 && (choice_.images.empty() || isNamed(raw) || isNamed(topic));
}

bool DepthTopics::isNamed(const std::string& image_topic) const {
  return std::find(choice_.images.begin(), choice_.images.end(), image_topic) != choice_.images.end();
}

void DepthTopics::add(const BagMessage& message, std::deque<BagFrame>& frames) {
  const std::string& type = message.content->getDataType();
  last_time_ = message.time;
  if (!wants(message.topic, type)) return;
  if (type == kInfoType) {
    addInfo(message, frames);
  } else {
    addImage(message, frames);
  }
}

void DepthTopics::addImage(const BagMessage& message, std::deque<BagFrame>& frames) {
  const std::string name = imageTopicOf(message.topic, message.content->getDataType());
  const auto known = by_image_.find(name);
  if (known != by_image_.end() && known->second == nullptr) return;
  DepthMessage depth;
  if (message.content->getDataType() == kCompressedType) {
    depth.compressed = message.content->instantiate<sensor_msgs::CompressedImage>();
    depth.image = describeCompressedDepth(*depth.compressed);
    if (!depth.image) {
      others_[message.topic] = depth.compressed->format.substr(0, 64);
      return;
    }
  } else {
    depth.image = message.content->instantiate<sensor_msgs::Image>();
  }

  DepthTopic* const topic = findOrPick(name, *depth.image);
  if (topic == nullptr) return;
  ++topic->images;
  InfoMatcher::Frames whole;
  if (choice_.camera) {
    whole.emplace_back();
    whole.back().image = depth.image;
    whole.back().compressed = depth.compressed;
    whole.back().info = boost::make_shared<sensor_msgs::CameraInfo>(
        makeCameraInfo(depth.image->header, *choice_.camera, static_cast<int>(depth.image->width),
                       static_cast<int>(depth.image->height)));
  } else {
    if (topic->info.empty() && findInfoTopic(*topic, *depth.image))
      topic->matcher.matchWaiting(infosOf(*topic), whole);
    topic->matcher.addImage(depth, infosOf(*topic), {}, whole);
  }
  append(*topic, whole, message.time, frames);
}

void DepthTopics::addInfo(const BagMessage& message, std::deque<BagFrame>& frames) {
  const sensor_msgs::CameraInfoConstPtr info = message.content->instantiate<sensor_msgs::CameraInfo>();
  infos_[message.topic].add(info, {});
  for (DepthTopic& topic : topics_) {
    if (topic.info.empty() && isInfoTopicOf(topic.image, message.topic)) topic.info = message.topic;
    if (topic.info != message.topic) continue;
    InfoMatcher::Frames whole;
    topic.matcher.addInfo(info->header.stamp, infosOf(topic), whole);
    append(topic, whole, message.time, frames);
  }
}

void DepthTopics::finish(std::deque<BagFrame>& frames) {
  for (DepthTopic& topic : topics_) {
    InfoMatcher::Frames whole;
    topic.matcher.finish(infosOf(topic), whole);
    append(topic, whole, last_time_, frames);
  }
}

void DepthTopics::append(DepthTopic& topic, InfoMatcher::Frames& whole, const ros::Time& time,
                         std::deque<BagFrame>& frames) {
  for (InputFrame& frame : whole) {
    if (topic.matcher.hasFallenBack()) ++topic.approximate;
    frame.needs_rectification = needsRectification(choice_.rectify, topic.image);
    frames.push_back({&topic, std::move(frame), time});
  }
}

const InfoHistory& DepthTopics::infosOf(const DepthTopic& topic) const {
  const auto found = infos_.find(topic.info);
  return found == infos_.end() ? no_infos_ : found->second;
}

DepthTopic* DepthTopics::findOrPick(const std::string& topic, const sensor_msgs::Image& image) {
  const auto known = by_image_.find(topic);
  if (known != by_image_.end()) return known->second;
  if (choice_.images.empty() && (!isDepthEncoding(topic, image.encoding) || isLabelsTopic(topic))) {
    others_[topic] = image.encoding;
    return by_image_[topic] = nullptr;
  }
  std::string result_namespace = resultNamespaceOf(topic);
  const bool taken = std::any_of(topics_.begin(), topics_.end(), [&](const DepthTopic& other) {
    return other.result_namespace == result_namespace;
  });
  if (taken) result_namespace = topic + "/plane_segmenter";
  topics_.push_back({topic, infoTopicFor(topic), result_namespace,
                     InfoMatcher(choice_.matching, kWaiting, InfoMatcher::FallbackRule::kWhenFull)});
  return by_image_[topic] = &topics_.back();
}

// The topic that is named, or one of the usual ones that is known to be in the bag; otherwise none yet.
std::string DepthTopics::infoTopicFor(const std::string& image_topic) const {
  if (choice_.infos.size() == 1) return choice_.infos.front();
  for (std::size_t i = 0; i < choice_.infos.size(); ++i) {
    if (choice_.images[i] == image_topic || rawTopicOf(choice_.images[i]) == image_topic)
      return choice_.infos[i];
  }
  for (const std::string& name : {infoTopicOf(image_topic), viewerInfoTopicOf(image_topic)}) {
    if (types_.count(name) != 0 || infos_.count(name) != 0) return name;
  }
  return {};
}

// Searches a camera_info topic of any name with the image's frame and size.
bool DepthTopics::findInfoTopic(DepthTopic& topic, const sensor_msgs::Image& image) const {
  if (image.header.frame_id.empty()) return false;
  for (const auto& [name, infos] : infos_) {
    const sensor_msgs::CameraInfoConstPtr info = infos.newestFor(image, true);
    if (!info || info->header.frame_id.empty()) continue;
    topic.info = name;
    return true;
  }
  return false;
}

std::vector<std::string> DepthTopics::infoTopics() const {
  std::vector<std::string> names;
  for (const auto& [name, infos] : infos_) names.push_back(name);
  return names;
}

}  // namespace line_plane_segmentation
