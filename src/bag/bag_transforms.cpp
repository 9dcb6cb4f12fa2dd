// SPDX-License-Identifier: BSD-3-Clause
#include "bag_transforms.h"

#include <tf2_msgs/TFMessage.h>

#include <vector>

namespace line_plane_segmentation {
namespace {

constexpr char kStatic[] = "/tf_static";

// Bags recorded before tf2 have the same message under its old type name, which instantiate() would reject.
tf2_msgs::TFMessage messageOf(const topic_tools::ShapeShifter& content) {
  std::vector<std::uint8_t> bytes(content.size());
  ros::serialization::OStream out(bytes.data(), content.size());
  content.write(out);
  ros::serialization::IStream in(bytes.data(), content.size());
  tf2_msgs::TFMessage message;
  ros::serialization::deserialize(in, message);
  return message;
}

}  // namespace

bool BagTransforms::wants(const std::string& topic, const std::string& datatype) {
  return (topic == "/tf" || topic == kStatic) &&
         (datatype == "tf2_msgs/TFMessage" || datatype == "tf/tfMessage");
}

void BagTransforms::add(const BagMessage& message) {
  if (!wants(message.topic, message.content->getDataType())) return;
  for (const auto& transform : messageOf(*message.content).transforms) {
    const bool is_static = message.topic == kStatic;
    if (!is_static && jump_detector_.jumpedBack(transform.child_frame_id, transform.header.stamp))
      buffer_.clear();
    buffer_.setTransform(transform, "bag", is_static);
  }
}

}  // namespace line_plane_segmentation
