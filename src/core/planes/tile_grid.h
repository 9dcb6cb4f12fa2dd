// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "depth/depth_image.h"

namespace line_plane_segmentation {

/// The image in square tiles, each with its nearest and farthest depth: where a plane cannot have inliers is
/// known without a look at the pixels.
class TileGrid {
 public:
  static constexpr int kSide = 16;  ///< [px]

  /// A tile row's stretch of tiles that may hold inliers, as columns of pixels: first to last - 1.
  struct Span {
    int tile_row, first, last;
  };

  void build(const DepthImage& depth);

  /// Takes pixels away from the tile that holds (u, v).
  void remove(int u, int v, int count) { pixels_[tileOf(u, v)] -= count; }

  /// Bound from above of the pixels that can belong to the plane n . p + d = 0 and hang together with pixel
  /// (u, v): all that are in tiles with an inlier possible, reached from the pixel's tile over tiles side by
  /// side. The tiles are kept for spans().
  int boundInliers(const ViewRays& rays, const Eigen::Vector3f& normal, float d, float threshold, int u,
                   int v);

  /// The tiles of the last boundInliers(), from the top.
  const std::vector<Span>& spans();

 private:
  std::size_t tileOf(int u, int v) const {
    return static_cast<std::size_t>(v / kSide) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(u / kSide);
  }
  bool mayHoldInlier(const ViewRays& rays, const Eigen::Vector3f& normal, float d, float threshold,
                     int tile) const;

  int width_ = 0, height_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<float> nearest_, farthest_;  // [m] as built: bounds stay bounds when pixels go
  std::vector<int> pixels_;                // valid and not taken away
  std::vector<std::uint8_t> reached_;
  std::vector<int> stack_;
  std::vector<Span> spans_;
};

}  // namespace line_plane_segmentation
