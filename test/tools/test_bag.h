// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace line_plane_segmentation {

constexpr std::uint32_t kBagWidth = 160;
constexpr std::uint32_t kBagHeight = 120;
constexpr char kBagFrame[] = "camera_depth_optical_frame";

/// The recording time, and the stamp 50 ms before it, of the i-th image of a test's bag.
inline ros::Time recordingTime(int i) { return ros::Time(1000, 50'000'000) + ros::Duration(0.1 * i); }
inline ros::Time stampOf(int i) { return ros::Time(1000) + ros::Duration(0.1 * i); }

/// A wall so far away [mm], across the whole view; 16UC1. Grained, so that it compresses as real images do.
inline sensor_msgs::Image wallImage(int i, std::uint16_t distance = 1500) {
  sensor_msgs::Image image;
  image.header.stamp = stampOf(i);
  image.header.frame_id = kBagFrame;
  image.width = kBagWidth;
  image.height = kBagHeight;
  image.encoding = "16UC1";
  image.step = 2 * kBagWidth;
  std::uint32_t random = static_cast<std::uint32_t>(i) + 1;
  for (std::uint32_t pixel = 0; pixel < kBagWidth * kBagHeight; ++pixel) {
    random = random * 1664525U + 1013904223U;
    const std::uint32_t depth = distance - 8 + (random >> 28U);
    image.data.push_back(static_cast<std::uint8_t>(depth & 255U));
    image.data.push_back(static_cast<std::uint8_t>(depth >> 8U));
  }
  return image;
}

inline sensor_msgs::CameraInfo wallInfo(int i) {
  sensor_msgs::CameraInfo info;
  info.header.stamp = stampOf(i);
  info.header.frame_id = kBagFrame;
  info.width = kBagWidth;
  info.height = kBagHeight;
  info.K = {131.25, 0, 79.5, 0, 131.25, 59.5, 0, 0, 1};
  info.P = {131.25, 0, 79.5, 0, 0, 131.25, 59.5, 0, 0, 0, 1, 0};
  return info;
}

/// The transform of a camera that stands at the world's origin.
inline tf2_msgs::TFMessage placeInWorld(int i) {
  geometry_msgs::TransformStamped place;
  place.header.stamp = stampOf(i);
  place.header.frame_id = "world";
  place.child_frame_id = kBagFrame;
  place.transform.rotation.w = 1.0;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(place);
  return message;
}

/// A bag of `frames` pictures of a wall on /camera/depth/image_raw.
inline void writeWallBag(const std::filesystem::path& file, int frames,
                         rosbag::CompressionType compression = rosbag::compression::Uncompressed,
                         std::uint32_t chunk_bytes = 768 * 1024) {
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  bag.setCompression(compression);
  bag.setChunkThreshold(chunk_bytes);
  for (int i = 0; i < frames; ++i) {
    bag.write("/camera/depth/image_raw", recordingTime(i), wallImage(i));
    bag.write("/camera/depth/camera_info", recordingTime(i), wallInfo(i));
  }
  bag.close();
}

/// All messages of one type by their topics.
template <typename Message>
std::map<std::string, std::vector<boost::shared_ptr<Message>>> readAll(const std::filesystem::path& file) {
  std::map<std::string, std::vector<boost::shared_ptr<Message>>> messages;
  const rosbag::Bag bag(file.string());
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TypeQuery(ros::message_traits::datatype<Message>()))) {
    messages[message.getTopic()].push_back(message.instantiate<Message>());
  }
  return messages;
}

/// How many messages each topic of a bag has.
inline std::map<std::string, int> countTopics(const std::filesystem::path& file) {
  std::map<std::string, int> counts;
  const rosbag::Bag bag(file.string());
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) ++counts[message.getTopic()];
  return counts;
}

/// The bytes of a message as they go over the wire.
template <typename Message>
std::string bytesOf(const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

}  // namespace line_plane_segmentation
