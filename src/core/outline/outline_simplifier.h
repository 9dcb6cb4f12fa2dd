// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "outline/outline_borders.h"

namespace line_plane_segmentation {

/// Simplifies the borders of a plane together, so that none crosses itself or another.
///
/// Douglas and Peucker's method, with one more condition: a piece of border may be pulled straight only if it
/// sweeps over no corner of the other borders or of the rest of its own. So it meets nothing on its way, and
/// the borders stay simple, apart, and nested as they were. Pieces that would meet something are split on, in
/// the end to single straight runs.
///
/// Where two pixels touch only at a corner, the two passes of the border become two points, each drawn in by
/// kInset toward its own pixel: nothing touches.
class BorderSimplifier {
 public:
  static constexpr double kInset = 0.125;  ///< [px] in x and in y

  /// Forgets all borders and takes the image that the next ones come from.
  void reset(const std::uint16_t* labels, int width, int height);

  /// Announces a border of the plane; all have to be before the first is simplified. `corners` holds count +
  /// 1 corners, the first one again at the end, as BorderFollower leaves them.
  void add(const Corner* corners, std::size_t count);

  /// Appends the points that remain of an announced border [px, corner (0, 0) of the image at (-0.5, -0.5)]:
  /// at least three, of the same orientation. All of the border lies within `tolerance` [px] of them, kInset
  /// aside. Takes O(n log n) for n corners plus the length of the border. Once all borders of the image have
  /// visited as many corners as it has pixels, and at least 640 * 480, which only borders that wind closely
  /// do, the rest keep all of their corners.
  void simplify(const Corner* corners, std::size_t count, double tolerance,
                std::vector<Eigen::Vector2d>& points);

  /// Makes room for the next plane; to be called with every border that was announced.
  void forget(const Corner* corners, std::size_t count);

 private:
  struct Piece;

  std::size_t findSplit(const Corner* corners, const Piece& piece, double squared_tolerance);
  bool pullStraight(const Corner* corners, const Piece& piece, std::int64_t min_cross,
                    std::int64_t max_cross);
  bool sweepsFree(const Corner* corners, const Piece& piece, std::int64_t min_cross, std::int64_t max_cross);
  bool isPassedIn(int y, int left, int right) const;
  bool sweepsOver(const Corner* corners, const Piece& piece, Corner corner) const;
  Eigen::Vector2d insetAt(Corner before, Corner corner, Corner after) const;

  std::uint16_t labelAt(int x, int y) const {
    return labels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }
  void pass(Corner corner);
  void passNoMore(Corner corner);
  std::size_t wordOf(int x, int y) const {
    return static_cast<std::size_t>(y) * words_per_row_ + static_cast<std::size_t>(x) / 64;
  }

  const std::uint16_t* labels_ = nullptr;
  int width_ = 0, height_ = 0;
  std::size_t words_per_row_ = 0;
  std::int64_t work_left_ = 0;  // [corner visits] of this image; at 0 borders keep all corners
  // One bit for each corner of the image: passed by what the borders are at the moment, and passed twice.
  std::vector<std::uint64_t> once_, twice_;
};

}  // namespace line_plane_segmentation
