// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_camera_messages.h"

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/predef/other/endian.h>
#include <algorithm>
#include <boost/make_shared.hpp>
#include <cstddef>

namespace line_plane_segmentation {

sensor_msgs::ImagePtr imageMessage(const std_msgs::Header& header, int width, int height) {
  const auto image = boost::make_shared<sensor_msgs::Image>();
  image->header = header;
  image->width = static_cast<std::uint32_t>(width);
  image->height = static_cast<std::uint32_t>(height);
  image->encoding = sensor_msgs::image_encodings::TYPE_16UC1;
  image->is_bigendian = BOOST_ENDIAN_BIG_BYTE ? 1 : 0;
  image->step = image->width * static_cast<std::uint32_t>(sizeof(std::uint16_t));
  image->data.resize(static_cast<std::size_t>(image->step) * image->height);
  return image;
}

// What a vector allocates is aligned for every type.
std::uint16_t* pixelsOf(sensor_msgs::Image& image) {
  return static_cast<std::uint16_t*>(static_cast<void*>(image.data.data()));
}

sensor_msgs::ImagePtr labelsMessage(const std_msgs::Header& header, const simulation::Rendering& picture) {
  const auto image = imageMessage(header, picture.width, picture.height);
  std::copy(picture.labels.begin(), picture.labels.end(), pixelsOf(*image));
  return image;
}

sensor_msgs::CameraInfo infoMessage(const std_msgs::Header& header, const CameraIntrinsics& k,
                                    const sensor_msgs::Image& image) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = image.width;
  info.height = image.height;
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(5, 0.0);
  info.K = {k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {k.fx, 0.0, k.cx, 0.0, 0.0, k.fy, k.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
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
