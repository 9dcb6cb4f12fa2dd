// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "refine/label_runs.h"

namespace line_plane_segmentation {

/// A corner where four pixels meet: (x, y) is the upper left corner of pixel (x, y), so it lies at
/// (x - 0.5, y - 0.5) in pixel coordinates.
struct Corner {
  std::int32_t x = 0, y = 0;
};

/// A closed border between the pixels of one label and the rest, along the cracks between pixels.
struct Border {
  std::uint16_t label = 0;
  std::int64_t area = 0;  ///< [px] that it encloses: positive round a part, negative round a hole
  std::size_t first = 0;  ///< its first corner, the leftmost of the topmost
  std::size_t count = 0;  ///< its corners, all turns; after the last one comes the first once more
};

/// Finds the borders of all labels in one pass over the runs of a label image, and follows each from crack to
/// crack.
///
/// Parts are 4-connected, so holes are 8-connected: where two pixels of a label touch only at a corner, the
/// border turns round each of them and passes that corner twice. The labelled pixels are on the left hand
/// as one walks along the border over the picture, which runs counterclockwise round parts and clockwise
/// round holes as one sees the picture.
class BorderFollower {
 public:
  /// Follows the borders of labels 1 to `label_count`; larger ones count as no label. Left out are borders
  /// that enclose fewer than `min_area` pixels; of each label the largest part is always there.
  /// Time and memory are linear in the number of pixels.
  /// @param runs  the labels as runs; neighbours in a row may have the same label
  void follow(const std::uint16_t* labels, const LabelRuns& runs, int width, int height, int label_count,
              std::int64_t min_area);

  const std::vector<Corner>& corners() const { return corners_; }

  /// By label; in each the parts before the holes, and each of them the largest first.
  const std::vector<Border>& borders() const { return borders_; }

 private:
  enum Direction : unsigned { kDown, kRight, kUp, kLeft };

  /// A straight piece of a border, up to its next turn.
  struct Run {
    int steps = 0;
    bool turns_left = false;
  };

  void followFrom(int x, int y, Direction direction);
  Run runFrom(int x, int y, unsigned direction) const;
  static Run runAlong(const std::uint16_t* left, std::ptrdiff_t to_right, std::ptrdiff_t step, int room,
                      bool right_in_image);
  std::size_t pixelAt(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  // Two bits for each pixel. Corners at the right and the lower edge of the image belong to no pixel; nothing
  // is marked there, but the place is touched.
  static constexpr std::size_t kSeenInByte = 4;
  int seenAt(std::size_t pixel) const { return seen_[pixel / kSeenInByte] >> (pixel % kSeenInByte * 2); }
  void markSeen(std::size_t pixel, unsigned kinds) {
    std::uint8_t& byte = seen_[pixel / kSeenInByte];
    byte = static_cast<std::uint8_t>(byte | kinds << (pixel % kSeenInByte * 2));
  }

  const std::uint16_t* labels_ = nullptr;
  int width_ = 0, height_ = 0;
  std::int64_t min_area_ = 0;
  std::vector<Corner> corners_;
  std::vector<Border> borders_;
  std::vector<std::int64_t> largest_;  // area of the largest part so far, by label
  // Which of the borders that may start at a pixel's upper left corner were followed.
  std::vector<std::uint8_t> seen_;
};

}  // namespace line_plane_segmentation
