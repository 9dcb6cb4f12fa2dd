// SPDX-License-Identifier: BSD-3-Clause
#include "planes/tile_grid.h"

#include <algorithm>
#include <limits>

namespace line_plane_segmentation {

void TileGrid::build(const DepthImage& depth) {
  width_ = depth.width;
  height_ = depth.height;
  columns_ = (width_ + kSide - 1) / kSide;
  rows_ = (height_ + kSide - 1) / kSide;
  const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  nearest_.assign(count, std::numeric_limits<float>::max());
  farthest_.assign(count, 0.0F);
  pixels_.assign(count, 0);
  reached_.assign(count, 0);
  stack_.reserve(count);
  for (int v = 0; v < height_; ++v) {
    const float* z = depth.row(v);
    for (int first = 0; first < width_; first += kSide) {
      const std::size_t tile = tileOf(first, v);
      const int last = std::min(first + kSide, width_);
      float nearest = nearest_[tile], farthest = farthest_[tile];
      int pixels = 0;
      for (int u = first; u < last; ++u) {
        nearest = std::min(nearest, z[u] > 0.0F ? z[u] : nearest);
        farthest = std::max(farthest, z[u]);
        pixels += z[u] > 0.0F;
      }
      nearest_[tile] = nearest;
      farthest_[tile] = farthest;
      pixels_[tile] += pixels;
    }
  }
}

bool TileGrid::mayHoldInlier(const ViewRays& rays, const Eigen::Vector3f& normal, float d, float threshold,
                             int tile) const {
  const std::size_t t = static_cast<std::size_t>(tile);
  if (pixels_[t] == 0) return false;
  const int u0 = (tile % columns_) * kSide, v0 = (tile / columns_) * kSide;
  const float x[2] = {rays.x[u0], rays.x[std::min(u0 + kSide, width_) - 1]};
  const float y[2] = {rays.y[v0], rays.y[std::min(v0 + kSide, height_) - 1]};
  // n . p = z (n . ray) is linear in z, x and y each, so its extremes lie at the corners of the tile's box.
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const float xi : x) {
    for (const float yi : y) {
      const float slope = normal.x() * xi + normal.y() * yi + normal.z();
      for (const float z : {nearest_[t], farthest_[t]}) {
        low = std::min(low, z * slope);
        high = std::max(high, z * slope);
      }
    }
  }
  const float margin = threshold + 1e-5F * std::max(1.0F, farthest_[t]);  // for rounding
  return low + d < margin && high + d > -margin;
}

int TileGrid::boundInliers(const ViewRays& rays, const Eigen::Vector3f& normal, float d, float threshold,
                           int u, int v) {
  std::fill(reached_.begin(), reached_.end(), std::uint8_t{0});
  stack_.clear();
  int bound = 0;
  const auto visit = [&](int tile) {
    std::uint8_t& reached = reached_[tile];
    if (reached != 0 || !mayHoldInlier(rays, normal, d, threshold, tile)) return;
    reached = 1;
    bound += pixels_[tile];
    stack_.push_back(tile);
  };
  visit(static_cast<int>(tileOf(u, v)));
  while (!stack_.empty()) {
    const int tile = stack_.back();
    stack_.pop_back();
    const int column = tile % columns_;
    if (column > 0) visit(tile - 1);
    if (column + 1 < columns_) visit(tile + 1);
    if (tile >= columns_) visit(tile - columns_);
    if (tile + columns_ < columns_ * rows_) visit(tile + columns_);
  }
  return bound;
}

const std::vector<TileGrid::Span>& TileGrid::spans() {
  spans_.clear();
  for (int row = 0; row < rows_; ++row) {
    const std::uint8_t* reached =
        reached_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    for (int column = 0; column < columns_;) {
      if (reached[column] == 0) {
        ++column;
        continue;
      }
      const int first = column;
      while (column < columns_ && reached[column] != 0) ++column;
      spans_.push_back({row, first * kSide, std::min(column * kSide, width_)});
    }
  }
  return spans_;
}

}  // namespace line_plane_segmentation
