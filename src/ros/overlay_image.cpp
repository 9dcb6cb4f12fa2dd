// SPDX-License-Identifier: BSD-3-Clause
#include <sensor_msgs/image_encodings.h>

#include <vector>

#include "conversions.h"
#include "depth_overlay.h"
#include "image_message.h"
#include "label_tables.h"

namespace line_plane_segmentation {
namespace {

// Labels of planes that are not published stay grey.
std::vector<LabelTint> tintsOf(const SegmentedFrame& frame) {
  const std::vector<Color> colors = labelColors(frame, Color{});
  const std::vector<std::uint16_t> published = publishedLabels(frame);
  std::vector<LabelTint> tints(colors.size());
  for (std::size_t label = 0; label < tints.size(); ++label)
    tints[label] = {published[label] != 0, colors[label]};
  return tints;
}

}  // namespace

sensor_msgs::Image::Ptr overlayImage(const SegmentedFrame& frame) {
  auto image = makeImage(frame.header, sensor_msgs::image_encodings::RGB8, frame.segmentation.width,
                         frame.segmentation.height, 3);
  drawDepthOverlay(frame.depth, frame.range, frame.segmentation.labels.data(), tintsOf(frame),
                   image->data.data());
  return image;
}

}  // namespace line_plane_segmentation
