// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_camera_messages.h"

#include <sensor_msgs/image_encodings.h>

#include <algorithm>

#include "image_message.h"

namespace line_plane_segmentation {

sensor_msgs::ImagePtr imageMessage(const std_msgs::Header& header, int width, int height) {
  return makeImage(header, sensor_msgs::image_encodings::TYPE_16UC1, width, height, sizeof(std::uint16_t));
}

// Memory that a vector allocates is aligned for every fundamental type.
std::uint16_t* pixelsOf(sensor_msgs::Image& image) {
  return static_cast<std::uint16_t*>(static_cast<void*>(image.data.data()));
}

sensor_msgs::ImagePtr labelsMessage(const std_msgs::Header& header, const simulation::Rendering& picture) {
  const auto image = imageMessage(header, picture.width, picture.height);
  std::copy(picture.labels.begin(), picture.labels.end(), pixelsOf(*image));
  return image;
}

geometry_msgs::TransformStamped transformMessage(const Eigen::Isometry3d& pose,
                                                 const std_msgs::Header& header,
                                                 const std::string& parent_frame) {
  const Eigen::Quaterniond rotation(pose.linear());
  geometry_msgs::TransformStamped message;
  message.header.stamp = header.stamp;
  message.header.frame_id = parent_frame;
  message.child_frame_id = header.frame_id;
  message.transform.translation.x = pose.translation().x();
  message.transform.translation.y = pose.translation().y();
  message.transform.translation.z = pose.translation().z();
  message.transform.rotation.x = rotation.x();
  message.transform.rotation.y = rotation.y();
  message.transform.rotation.z = rotation.z();
  message.transform.rotation.w = rotation.w();
  return message;
}

}  // namespace line_plane_segmentation
