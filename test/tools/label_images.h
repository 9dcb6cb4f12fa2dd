// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "region_overlap.h"

namespace line_plane_segmentation {

/// So many pixels that carry these values in the truth and in the label image.
struct Pixels {
  std::uint16_t truth;
  std::uint16_t label;
  int count;
};

/// Counts a pair of images made of such pixels. Where they lie makes no difference to the measures.
inline RegionOverlaps countImages(const std::vector<Pixels>& pixels) {
  std::vector<std::uint16_t> truth;
  std::vector<std::uint16_t> labels;
  for (const Pixels& some : pixels) {
    truth.insert(truth.end(), static_cast<std::size_t>(some.count), some.truth);
    labels.insert(labels.end(), static_cast<std::size_t>(some.count), some.label);
  }
  return countOverlaps(truth.data(), labels.data(), truth.size());
}

}  // namespace line_plane_segmentation
