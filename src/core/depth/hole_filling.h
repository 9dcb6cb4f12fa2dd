// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// Fills small holes of a perforated depth image: one with many holes that a surface continues behind, such
/// as the lattice that registration to a colour image leaves, missing bands, or speckle. Without it, every
/// plane would fall apart into connected components of a few pixels.
class HoleFiller {
 public:
  /// Fills holes of a perforated image by linear interpolation of the inverse depth along the row, or else
  /// along the column, between pixels that agree within the noise. Leaves any other image unchanged.
  /// @param parameters  resolved; holes are filled up to 1.5 times the scanline spacing
  /// @return whether the image is perforated
  bool fill(const Parameters& parameters, DepthImage& depth);

  /// 1 for each pixel that the last fill() filled, else 0; valid if it returned true.
  const std::vector<std::uint8_t>& filled() const { return filled_; }

  /// Sets the pixels that the last fill() filled to 0. Only after it returned true.
  void removeFilled(DepthImage& depth) const;

 private:
  class Interpolation;

  void fillRows(const DepthImage& depth, const Interpolation& interpolation, int max_hole);
  void fillColumns(const DepthImage& depth, const Interpolation& interpolation, int max_hole);

  std::vector<std::uint8_t> filled_;

  // Buffers for one row:
  std::vector<std::uint8_t> marks_;
  std::vector<int> columns_;
  std::vector<int> last_valid_;  // row of the last valid pixel in each column
  std::vector<int> holes_;
};

}  // namespace line_plane_segmentation
