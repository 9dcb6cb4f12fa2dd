// SPDX-License-Identifier: BSD-3-Clause
#include "depth_overlay.h"

#include <cstddef>

namespace line_plane_segmentation {
namespace {

void computeGreys(const std::vector<float>& depth, std::vector<std::uint8_t>& greys) {
  constexpr float kWhiteDepth = 0.6F;  // [m]
  constexpr float kDarkestGrey = 25.0F, kWhite = 255.0F;
  // Conditional expressions instead of branches, so that the loop is vectorised.
  for (std::size_t u = 0; u < depth.size(); ++u) {
    const float light = kWhite * kWhiteDepth / depth[u];
    const float at_most_white = light < kWhite ? light : kWhite;
    const float grey = at_most_white > kDarkestGrey ? at_most_white : kDarkestGrey;
    greys[u] = static_cast<std::uint8_t>(static_cast<int>(depth[u] > 0.0F ? grey : 0.0F));
  }
}

// Weights in fifths: grey alone, or 2/5 of it and 3/5 of the colour, in integers.
struct Weights {
  unsigned grey = 5, r = 0, g = 0, b = 0;
};

std::vector<Weights> weightsOf(const std::vector<LabelTint>& tints) {
  std::vector<Weights> weights(tints.size());
  for (std::size_t label = 0; label < tints.size(); ++label) {
    const Color& color = tints[label].color;
    if (tints[label].tinted) weights[label] = {2, 3U * color.r, 3U * color.g, 3U * color.b};
  }
  return weights;
}

// A table lookup is faster than a division.
std::vector<std::uint8_t> tableOfFifths() {
  std::vector<std::uint8_t> fifths;
  for (int i = 0; i <= 5 * 255; ++i) fifths.push_back(static_cast<std::uint8_t>(i / 5));
  return fifths;
}

}  // namespace

void drawDepthOverlay(const DepthView& depth, const DepthRange& range, const std::uint16_t* labels,
                      const std::vector<LabelTint>& tints, std::uint8_t* pixels) {
  const std::vector<Weights> weights = weightsOf(tints);
  const std::vector<std::uint8_t> fifths = tableOfFifths();
  std::vector<float> metres(static_cast<std::size_t>(depth.width));
  std::vector<std::uint8_t> greys(metres.size());
  // Stores through uint8_t* may alias anything, so the compiler would reload the vectors' data pointers in
  // every iteration. Raw pointers avoid that.
  const Weights* const weights_of = weights.data();
  const std::uint8_t *const fifth_of = fifths.data(), *const grey = greys.data();
  for (int v = 0; v < depth.height; ++v) {
    loadRow(depth, v, range, metres.data());
    computeGreys(metres, greys);
    for (int u = 0; u < depth.width; ++u, pixels += 3) {
      const Weights& weight = weights_of[*labels++];
      const unsigned base = weight.grey * grey[u];
      pixels[0] = fifth_of[base + weight.r];
      pixels[1] = fifth_of[base + weight.g];
      pixels[2] = fifth_of[base + weight.b];
    }
  }
}

}  // namespace line_plane_segmentation
