// SPDX-License-Identifier: BSD-3-Clause
#include <sensor_msgs/image_encodings.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "conversions.h"
#include "image_message.h"
#include "label_tables.h"

namespace line_plane_segmentation {

sensor_msgs::Image::Ptr labelsImage(const SegmentedFrame& frame) {
  const Segmentation& segmentation = frame.segmentation;
  auto image = makeImage(frame.header, sensor_msgs::image_encodings::TYPE_16UC1, segmentation.width,
                         segmentation.height, sizeof(std::uint16_t));
  if (image->data.empty()) return image;
  if (frame.published.planes.size() == segmentation.planes.size()) {
    // Common case: all planes are published, and labels are copied unchanged.
    std::memcpy(image->data.data(), segmentation.labels.data(), image->data.size());
    return image;
  }
  const std::vector<std::uint16_t> published = publishedLabels(frame);
  std::uint8_t* pixel = image->data.data();
  for (const std::uint16_t label : segmentation.labels) {
    std::memcpy(pixel, &published[label], sizeof label);
    pixel += sizeof label;
  }
  return image;
}

}  // namespace line_plane_segmentation
