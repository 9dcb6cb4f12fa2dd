// SPDX-License-Identifier: BSD-3-Clause
#include "outline/outline_simplifier.h"

#include <algorithm>
#include <array>
#include <utility>

#include "kernels/multiversion.h"

namespace line_plane_segmentation {
namespace {

/// So often a piece is split at its farthest corner, then in its middle: no border takes quadratic time.
constexpr int kMaxGreedyDepth = 32;
/// Halving ends after 32 more.
constexpr std::size_t kMaxDepth = 72;
/// A piece among more corners of others than this counts as not free, which bounds the work.
constexpr int kMaxOthers = 16;
/// Corner visits allowed in small images, as in a VGA image: the length of borders grows less than the area.
constexpr std::int64_t kLeastWork = 640 * 480;
/// By so much [px] of x and of y other points keep away from a chord, each being drawn in at most.
constexpr double kClearance = 2.4 * BorderSimplifier::kInset;

std::int64_t dot(Corner a, Corner b) { return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y; }
std::int64_t cross(Corner a, Corner b) { return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x; }
Corner operator-(Corner a, Corner b) { return {a.x - b.x, a.y - b.y}; }
bool operator==(Corner a, Corner b) { return a.x == b.x && a.y == b.y; }

std::size_t farthestFrom(Corner from, const Corner* corners, std::size_t count) {
  std::size_t farthest = 0;
  std::int64_t greatest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Corner offset = corners[i] - from;
    const std::int64_t distance = dot(offset, offset);
    if (distance > greatest) {
      greatest = distance;
      farthest = i;
    }
  }
  return farthest;
}

/// Signed distances to the line through two corners, times its length: cross products.
struct Deviation {
  std::int64_t min = 0, max = 0;
  std::size_t farthest = 0;
};

LPS_MULTIVERSION
Deviation deviationOf(const Corner* corners, std::size_t first, std::size_t last, Corner from, Corner along) {
  // With the index in the lower bits, so that the loop has no branch, which would be mispredicted. The cross
  // products are below twice the number of pixels.
  constexpr std::int64_t kFactor = std::int64_t{1} << 32;
  std::int64_t min = 0, max = 0;
  for (std::size_t i = first; i < last; ++i) {
    const std::int64_t key = cross(along, corners[i] - from) * kFactor + static_cast<std::int64_t>(i - first);
    min = std::min(min, key);
    max = std::max(max, key);
  }
  Deviation deviation;
  const std::int64_t at_min = min & (kFactor - 1), at_max = max & (kFactor - 1);
  deviation.min = (min - at_min) / kFactor;
  deviation.max = (max - at_max) / kFactor;
  deviation.farthest = first + static_cast<std::size_t>(-deviation.min > deviation.max ? at_min : at_max);
  return deviation;
}

/// The bits of a word of corners from a column on, and up to one.
std::uint64_t fromColumn(int x) { return ~std::uint64_t{0} << (x % 64); }
std::uint64_t upToColumn(int x) { return ~std::uint64_t{0} >> (63 - x % 64); }

/// Cross product with a chord up to which points are too near it.
double clearanceOf(Corner along) {
  return kClearance * static_cast<double>(std::abs(along.x) + std::abs(along.y));
}

/// All points whose cross product with a chord lies between two bounds, and those near to them.
class Strip {
 public:
  Strip(Corner from, Corner along, std::int64_t min_cross, std::int64_t max_cross)
      : from_(from),
        along_(along),
        lowest_(static_cast<double>(min_cross) - clearanceOf(along)),
        highest_(static_cast<double>(max_cross) + clearanceOf(along)) {
    if (along.y != 0) columns_per_cross_ = 1.0 / along.y;
  }

  /// Narrows the columns left to right, both included, to those of row y in the strip. False if none is.
  bool clipRow(int y, int& left, int& right) const {
    // The cross product of (x, y) is offset - along.y (x - from.x).
    const double offset = static_cast<double>(along_.x) * (y - from_.y);
    if (along_.y == 0) return lowest_ <= offset && offset <= highest_;
    double first = from_.x + (offset - lowest_) * columns_per_cross_;
    double last = from_.x + (offset - highest_) * columns_per_cross_;
    if (first > last) std::swap(first, last);
    if (last < left || first > right) return false;
    if (first > left) left = static_cast<int>(first) + 1;
    if (last < right) right = static_cast<int>(last);
    return left <= right;
  }

 private:
  Corner from_, along_;
  double lowest_, highest_, columns_per_cross_ = 0.0;
};

}  // namespace

struct BorderSimplifier::Piece {
  std::size_t first, last;
  int depth;
};

void BorderSimplifier::reset(const std::uint16_t* labels, int width, int height) {
  labels_ = labels;
  width_ = width;
  height_ = height;
  words_per_row_ = static_cast<std::size_t>(width) / 64 + 1;
  const std::size_t words = words_per_row_ * (static_cast<std::size_t>(height) + 1);
  work_left_ = std::max(kLeastWork, std::int64_t{width} * height);
  once_.assign(words, 0);
  twice_.assign(words, 0);
}

void BorderSimplifier::pass(Corner corner) {
  const std::size_t word = wordOf(corner.x, corner.y);
  const std::uint64_t bit = std::uint64_t{1} << (corner.x % 64);
  twice_[word] |= once_[word] & bit;
  once_[word] |= bit;
}

void BorderSimplifier::passNoMore(Corner corner) {
  const std::size_t word = wordOf(corner.x, corner.y);
  const std::uint64_t bit = std::uint64_t{1} << (corner.x % 64);
  once_[word] &= ~bit | twice_[word];
  twice_[word] &= ~bit;
}

void BorderSimplifier::add(const Corner* corners, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) pass(corners[i]);
}

void BorderSimplifier::forget(const Corner* corners, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t word = wordOf(corners[i].x, corners[i].y);
    once_[word] = twice_[word] = 0;
  }
}

void BorderSimplifier::simplify(const Corner* corners, std::size_t count, double tolerance,
                                std::vector<Eigen::Vector2d>& points) {
  // Three corners that span a triangle are kept whatever the tolerance, so that no ring collapses.
  const std::size_t opposite = farthestFrom(corners[0], corners, count);
  const std::size_t apex =
      deviationOf(corners, 0, count, corners[0], corners[opposite] - corners[0]).farthest;
  std::array<Piece, kMaxDepth> pieces;
  std::size_t size = 0;
  pieces[size++] = {std::max(apex, opposite), count, 0};
  pieces[size++] = {std::min(apex, opposite), std::max(apex, opposite), 0};
  pieces[size++] = {0, std::min(apex, opposite), 0};
  while (size > 0) {
    const Piece piece = pieces[--size];
    const std::size_t split = findSplit(corners, piece, tolerance * tolerance);
    if (split != piece.last) {
      pieces[size++] = {split, piece.last, piece.depth + 1};
      pieces[size++] = {piece.first, split, piece.depth + 1};
      continue;
    }
    const Corner corner = corners[piece.first];
    const Corner before = corners[piece.first > 0 ? piece.first - 1 : count - 1];
    points.push_back(Eigen::Vector2d(corner.x - 0.5, corner.y - 0.5) +
                     insetAt(before, corner, corners[piece.first + 1]));
  }
}

/// Pulls a piece straight if that is allowed.
/// @return where to split it otherwise, or its last corner
std::size_t BorderSimplifier::findSplit(const Corner* corners, const Piece& piece, double squared_tolerance) {
  if (piece.last - piece.first == 1) return piece.last;
  const std::size_t middle = piece.first + (piece.last - piece.first) / 2;
  const Corner from = corners[piece.first];
  const Corner along = corners[piece.last] - from;
  if (along == Corner{} || work_left_ <= 0) return middle;

  work_left_ -= static_cast<std::int64_t>(piece.last - piece.first);
  const Deviation deviation = deviationOf(corners, piece.first, piece.last, from, along);
  const std::size_t split = piece.depth < kMaxGreedyDepth ? deviation.farthest : middle;
  const std::int64_t squared_length = dot(along, along);
  const double limit = squared_tolerance * static_cast<double>(squared_length);
  const auto exceeds = [limit](std::int64_t a, std::int64_t b) {
    return static_cast<double>(a) * static_cast<double>(a) + static_cast<double>(b) * static_cast<double>(b) >
           limit;
  };
  if (exceeds(std::max(-deviation.min, deviation.max), 0)) return split;

  // Near the line, but perhaps beyond the ends of the chord.
  for (std::size_t i = piece.first + 1; i < piece.last; ++i) {
    const Corner offset = corners[i] - from;
    const std::int64_t position = dot(along, offset);
    const std::int64_t beyond = std::max(-position, position - squared_length);
    if (beyond > 0 && exceeds(beyond, cross(along, offset)))
      return piece.depth < kMaxGreedyDepth ? i : middle;
  }
  return pullStraight(corners, piece, deviation.min, deviation.max) ? piece.last : split;
}

bool BorderSimplifier::pullStraight(const Corner* corners, const Piece& piece, std::int64_t min_cross,
                                    std::int64_t max_cross) {
  work_left_ -= 2 * static_cast<std::int64_t>(piece.last - piece.first);
  for (std::size_t i = piece.first; i <= piece.last; ++i) passNoMore(corners[i]);
  const bool free = sweepsFree(corners, piece, min_cross, max_cross);
  const std::size_t step = free ? piece.last - piece.first : 1;
  for (std::size_t i = piece.first; i <= piece.last; i += step) pass(corners[i]);
  return free;
}

/// Looks at all corners in the strip along the chord and the box that hold the piece, its own taken out.
bool BorderSimplifier::sweepsFree(const Corner* corners, const Piece& piece, std::int64_t min_cross,
                                  std::int64_t max_cross) {
  const Corner from = corners[piece.first];
  Corner low = from, high = from;
  for (std::size_t i = piece.first + 1; i <= piece.last; ++i) {
    low = {std::min(low.x, corners[i].x), std::min(low.y, corners[i].y)};
    high = {std::max(high.x, corners[i].x), std::max(high.y, corners[i].y)};
  }
  const Strip strip(from, corners[piece.last] - from, min_cross, max_cross);
  work_left_ -= std::int64_t{high.y - low.y + 1} * (1 + (high.x - low.x) / 64);
  int others = 0;
  for (int y = low.y; y <= high.y; ++y) {
    int left = low.x, right = high.x;
    // Most rows hold no corner of others at all, which is found out sooner.
    if (!isPassedIn(y, left, right) || !strip.clipRow(y, left, right)) continue;
    const std::size_t first_word = wordOf(left, y), last_word = wordOf(right, y);
    for (std::size_t word = first_word; word <= last_word; ++word) {
      std::uint64_t bits = once_[word];
      if (word == first_word) bits &= fromColumn(left);
      if (word == last_word) bits &= upToColumn(right);
      const int first_x = static_cast<int>(word % words_per_row_) * 64;
      for (; bits != 0; bits &= bits - 1) {
        const int x = first_x + __builtin_ctzll(bits);
        work_left_ -= static_cast<std::int64_t>(piece.last - piece.first);
        if (++others > kMaxOthers || sweepsOver(corners, piece, {x, y})) return false;
      }
    }
  }
  return true;
}

/// Whether borders pass any corner of row y in the columns left to right, both included.
bool BorderSimplifier::isPassedIn(int y, int left, int right) const {
  const std::size_t first_word = wordOf(left, y), last_word = wordOf(right, y);
  if (first_word == last_word) return (once_[first_word] & fromColumn(left) & upToColumn(right)) != 0;
  std::uint64_t bits = (once_[first_word] & fromColumn(left)) | (once_[last_word] & upToColumn(right));
  for (std::size_t word = first_word + 1; word < last_word; ++word) bits |= once_[word];
  return bits != 0;
}

/// Whether a corner of another piece is nearly on the chord, or enclosed by the piece and its chord.
bool BorderSimplifier::sweepsOver(const Corner* corners, const Piece& piece, Corner corner) const {
  const Corner from = corners[piece.first], to = corners[piece.last];
  const Corner along = to - from;
  const std::int64_t side = cross(along, corner - from);
  const bool beside = std::min(from.x, to.x) <= corner.x && corner.x <= std::max(from.x, to.x) &&
                      std::min(from.y, to.y) <= corner.y && corner.y <= std::max(from.y, to.y);
  if (beside && static_cast<double>(std::abs(side)) <= clearanceOf(along)) return true;

  // Where the piece passes it too, the other pass is drawn in to the opposite side, by less than a pixel.
  Eigen::Vector2d inset(0.0, 0.0);
  for (std::size_t i = piece.first + 1; i < piece.last; ++i) {
    if (corners[i] == corner) inset += insetAt(corners[i - 1], corner, corners[i + 1]);
  }
  // The last columns and rows of corners left of the point and above it.
  const int left = inset.x() > 0.0 ? corner.x - 1 : corner.x,
            above = inset.y() > 0.0 ? corner.y - 1 : corner.y;
  // Crossings of the ray to the right.
  const auto lies_below = [above](Corner c) { return c.y > above; };
  bool enclosed = lies_below(from) != lies_below(to) && (side > 0) == (along.y > 0);
  bool was_below = lies_below(from);
  for (std::size_t i = piece.first; i < piece.last; ++i) {
    const bool is_below = lies_below(corners[i + 1]);
    enclosed ^= (was_below != is_below) & (corners[i].x > left);
    was_below = is_below;
  }
  return enclosed;
}

/// What a corner is drawn in by: nothing, but where the opposite pixel has the same label and borders meet.
Eigen::Vector2d BorderSimplifier::insetAt(Corner before, Corner corner, Corner after) const {
  // Toward the pixel between the two runs: the one that the border turns round, or the one that is missing.
  const bool left = before.x + after.x < 2 * corner.x, up = before.y + after.y < 2 * corner.y;
  const int x = corner.x - (left ? 1 : 0), y = corner.y - (up ? 1 : 0);
  const int opposite_x = corner.x - (left ? 0 : 1), opposite_y = corner.y - (up ? 0 : 1);
  if (opposite_x < 0 || opposite_y < 0 || opposite_x >= width_ || opposite_y >= height_) return {0.0, 0.0};
  if (labelAt(x, y) != labelAt(opposite_x, opposite_y)) return {0.0, 0.0};
  return {left ? -kInset : kInset, up ? -kInset : kInset};
}

}  // namespace line_plane_segmentation
