// SPDX-License-Identifier: BSD-3-Clause
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "image_message.h"
#include "label_tables.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {
namespace {

// Lightness falls with 1/z and does not depend on the rest of the image: a film of it does not flicker.
std::uint8_t greyOf(float z) {
  constexpr float kLightest = 0.6F;  // [m]
  constexpr float kDarkestGrey = 25.0F;
  if (!(z > 0.0F)) return 0;
  return static_cast<std::uint8_t>(std::max(kDarkestGrey, 255.0F * std::min(kLightest / z, 1.0F)));
}

// 60 % of the plane's colour over the grey, in integers.
std::uint8_t tinted(std::uint8_t grey, std::uint8_t color) {
  return static_cast<std::uint8_t>((2 * grey + 3 * color) / 5);
}

}  // namespace

sensor_msgs::Image::Ptr overlayImage(const SegmentedFrame& frame) {
  const int width = frame.segmentation.width;
  const int height = frame.segmentation.height;
  auto image = makeImage(frame.header, sensor_msgs::image_encodings::RGB8, width, height, 3);

  const std::vector<Color> colors = labelColors(frame, Color{});
  const std::vector<std::uint16_t> published = publishedLabels(frame);
  std::vector<float> depth(static_cast<std::size_t>(width));
  const std::uint16_t* label = frame.segmentation.labels.data();
  std::uint8_t* pixel = image->data.data();
  for (int v = 0; v < height; ++v) {
    loadRow(frame.depth, v, frame.range, depth.data());
    for (const float z : depth) {
      const std::uint8_t grey = greyOf(z);
      const Color& color = colors[*label];
      const bool in_plane = published[*label] != 0;
      pixel[0] = in_plane ? tinted(grey, color.r) : grey;
      pixel[1] = in_plane ? tinted(grey, color.g) : grey;
      pixel[2] = in_plane ? tinted(grey, color.b) : grey;
      pixel += 3;
      ++label;
    }
  }
  return image;
}

}  // namespace line_plane_segmentation
