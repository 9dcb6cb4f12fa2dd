// SPDX-License-Identifier: BSD-3-Clause
#include <sensor_msgs/image_encodings.h>

#include <cstring>

#include "image_message.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {

sensor_msgs::Image::Ptr labelsImage(const SegmentedFrame& frame) {
  const Segmentation& segmentation = frame.segmentation;
  auto image = makeImage(frame.header, sensor_msgs::image_encodings::TYPE_16UC1, segmentation.width,
                         segmentation.height, sizeof(std::uint16_t));
  if (!image->data.empty()) std::memcpy(image->data.data(), segmentation.labels.data(), image->data.size());
  return image;
}

}  // namespace line_plane_segmentation
