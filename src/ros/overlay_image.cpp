// SPDX-License-Identifier: BSD-3-Clause
#include <sensor_msgs/image_encodings.h>

#include <cstddef>
#include <vector>

#include "image_message.h"
#include "label_tables.h"
#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {
namespace {

// Lightness falls with 1/z and does not depend on the rest of the image: a film of it does not flicker.
void findGreys(const std::vector<float>& depth, std::vector<std::uint8_t>& greys) {
  constexpr float kLightest = 0.6F;  // [m]
  constexpr float kDarkestGrey = 25.0F, kWhite = 255.0F;
  // Without branches, of which no vectors could be made.
  for (std::size_t u = 0; u < depth.size(); ++u) {
    const float light = kWhite * kLightest / depth[u];
    const float at_most_white = light < kWhite ? light : kWhite;
    const float grey = at_most_white > kDarkestGrey ? at_most_white : kDarkestGrey;
    greys[u] = static_cast<std::uint8_t>(static_cast<int>(depth[u] > 0.0F ? grey : 0.0F));
  }
}

// What a grey becomes, in integers and fifths: itself, or what 60 % of a plane's colour over it make.
struct Tint {
  unsigned grey = 5, r = 0, g = 0, b = 0;
};

std::vector<Tint> tintsOf(const SegmentedFrame& frame) {
  const std::vector<Color> colors = labelColors(frame, Color{});
  const std::vector<std::uint16_t> published = publishedLabels(frame);
  std::vector<Tint> tints(colors.size());
  for (std::size_t label = 0; label < tints.size(); ++label) {
    const Color& color = colors[label];
    if (published[label] != 0) tints[label] = {2, 3U * color.r, 3U * color.g, 3U * color.b};
  }
  return tints;
}

// The fifth of every number that comes up, which is looked up faster than divided for.
std::vector<std::uint8_t> tableOfFifths() {
  std::vector<std::uint8_t> fifths;
  for (int i = 0; i <= 5 * 255; ++i) fifths.push_back(static_cast<std::uint8_t>(i / 5));
  return fifths;
}

}  // namespace

sensor_msgs::Image::Ptr overlayImage(const SegmentedFrame& frame) {
  const int width = frame.segmentation.width;
  const int height = frame.segmentation.height;
  auto image = makeImage(frame.header, sensor_msgs::image_encodings::RGB8, width, height, 3);

  const std::vector<Tint> tints = tintsOf(frame);
  const std::vector<std::uint8_t> fifths = tableOfFifths();
  std::vector<float> depth(static_cast<std::size_t>(width));
  std::vector<std::uint8_t> greys(depth.size());
  // Bytes that are written might be part of a vector, for all the compiler knows: so what is read goes past
  // the vectors.
  const Tint* const tint_of = tints.data();
  const std::uint8_t *const fifth_of = fifths.data(), *const grey = greys.data();
  const std::uint16_t* label = frame.segmentation.labels.data();
  std::uint8_t* pixel = image->data.data();
  for (int v = 0; v < height; ++v) {
    loadRow(frame.depth, v, frame.range, depth.data());
    findGreys(depth, greys);
    for (int u = 0; u < width; ++u, pixel += 3) {
      const Tint& tint = tint_of[*label++];
      const unsigned share = tint.grey * grey[u];
      pixel[0] = fifth_of[share + tint.r];
      pixel[1] = fifth_of[share + tint.g];
      pixel[2] = fifth_of[share + tint.b];
    }
  }
  return image;
}

}  // namespace line_plane_segmentation
