// SPDX-License-Identifier: BSD-3-Clause
#include "outline/outline_borders.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace line_plane_segmentation {
namespace {

/// What may start at the upper left corner of a pixel.
constexpr std::uint8_t kConvex = 1;  ///< the border that turns round this pixel
constexpr std::uint8_t kReflex = 2;  ///< the border that turns round the three others, which have one label

bool comesBefore(const Border& a, const Border& b) {
  if (a.label != b.label) return a.label < b.label;
  if ((a.area > 0) != (b.area > 0)) return a.area > 0;
  if (a.area != b.area) return std::abs(a.area) > std::abs(b.area);
  return a.first < b.first;
}

}  // namespace

void BorderFollower::follow(const std::uint16_t* labels, const LabelRuns& runs, int width, int height,
                            int label_count, std::int64_t min_area) {
  labels_ = labels;
  width_ = width;
  height_ = height;
  min_area_ = min_area;
  corners_.clear();
  borders_.clear();
  largest_.assign(static_cast<std::size_t>(label_count) + 1, 0);
  seen_.assign(pixelAt(width, height) / kSeenInByte + 1, 0);

  const auto is_label = [label_count](int value) {
    return static_cast<unsigned>(value - 1) < static_cast<unsigned>(label_count);
  };
  for (const LabelRun& run : runs.runs) {
    // A part's first pixel differs from its left and its upper neighbour, and so does a hole's. Nearly all
    // runs start nothing, so that is asked in one condition.
    const int x = run.first, y = run.row;
    const std::ptrdiff_t to_left = x > 0 ? 1 : 0, to_above = y > 0 ? width : 0;
    const std::uint16_t* const here = labels + pixelAt(x, y);
    const std::uint16_t left = x > 0 ? here[-to_left] : std::uint16_t{0};
    const std::uint16_t above = y > 0 ? here[-to_above] : std::uint16_t{0};
    const std::uint16_t above_left = here[-to_above - to_left];
    const bool is_convex = is_label(*here) & (*here != above) & (*here != left);
    const bool is_reflex = is_label(above) & (above == left) & (above == above_left) & (*here != above);
    const int kinds = (is_convex ? kConvex : 0) | (is_reflex ? kReflex : 0);
    const std::size_t pixel = pixelAt(x, y);
    if ((kinds & ~seenAt(pixel)) == 0) continue;
    if ((kinds & ~seenAt(pixel) & kConvex) != 0) followFrom(x, y, kDown);
    if ((kinds & ~seenAt(pixel) & kReflex) != 0) followFrom(x, y, kRight);
  }
  // Small parts that were the largest of their label only until a larger one was met.
  const auto is_left_out = [this](const Border& b) {
    return std::abs(b.area) < min_area_ && b.area != largest_[b.label];
  };
  borders_.erase(std::remove_if(borders_.begin(), borders_.end(), is_left_out), borders_.end());
  std::sort(borders_.begin(), borders_.end(), comesBefore);
}

/// Goes along a border. `left` is the pixel at the first crack on the left hand, which has the label,
/// `to_right` leads across the crack and `step` to the next one; `room` steps end at the edge of the image.
BorderFollower::Run BorderFollower::runAlong(const std::uint16_t* left, std::ptrdiff_t to_right,
                                             std::ptrdiff_t step, int room, bool right_in_image) {
  const std::uint16_t label = *left;
  for (int steps = 1; steps < room; ++steps) {
    left += step;
    if (*left != label) return {steps, true};
    if (right_in_image && left[to_right] == label) return {steps, false};
  }
  return {room, true};
}

/// The piece of a border that sets out from a corner in a direction.
BorderFollower::Run BorderFollower::runFrom(int x, int y, unsigned direction) const {
  const std::ptrdiff_t width = width_, below_right = y * width + x;
  switch (direction) {
    case kDown:
      return runAlong(labels_ + below_right, -1, width, height_ - y, x > 0);
    case kRight:
      return runAlong(labels_ + (below_right - width), width, 1, width_ - x, y < height_);
    case kUp:
      return runAlong(labels_ + (below_right - width - 1), 1, -width, y, x < width_);
    default:
      return runAlong(labels_ + (below_right - 1), -width, -1, x, y > 0);
  }
}

/// Follows a border round from a corner where it sets out in the given direction.
void BorderFollower::followFrom(int start_x, int start_y, Direction start_direction) {
  constexpr std::array<int, 4> kStepX = {0, 1, 0, -1}, kStepY = {1, 0, -1, 0};
  constexpr std::array<std::uint8_t, 4> kSeenTurningLeft = {0, 0, 0, kConvex};
  constexpr std::array<std::uint8_t, 4> kSeenTurningRight = {0, 0, kReflex, 0};
  const std::size_t first = corners_.size();
  std::int64_t area = 0;
  int x = start_x, y = start_y;
  unsigned direction = start_direction;
  do {
    // Each number by itself: a pair made first and then copied would wait for both to be stored.
    Corner& corner = corners_.emplace_back();
    corner.x = x;
    corner.y = y;
    const Run run = runFrom(x, y, direction);
    x += kStepX[direction] * run.steps;
    y += kStepY[direction] * run.steps;
    area -= std::int64_t{x} * (kStepY[direction] * run.steps);
    markSeen(pixelAt(x, y), run.turns_left ? kSeenTurningLeft[direction] : kSeenTurningRight[direction]);
    direction = (direction + (run.turns_left ? 1 : 3)) % 4;
  } while (x != start_x || y != start_y || direction != start_direction);

  const std::uint16_t label =
      labels_[pixelAt(start_x, start_y) - (start_direction == kDown ? 0 : pixelAt(0, 1))];
  std::int64_t& largest = largest_[label];
  if (std::abs(area) < min_area_ && area <= largest) {
    corners_.resize(first);
    return;
  }
  largest = std::max(largest, area);
  borders_.push_back({label, area, first, corners_.size() - first});
  corners_.push_back({start_x, start_y});
}

}  // namespace line_plane_segmentation
