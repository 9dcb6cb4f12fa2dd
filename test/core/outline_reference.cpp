// SPDX-License-Identifier: BSD-3-Clause
#include "core/outline_reference.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace line_plane_segmentation {
namespace {

/// Pixels of an image with a margin of one pixel on every side.
class Mask {
 public:
  Mask(int width, int height) : width_(width + 2), height_(height + 2) {
    pixels_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  }

  int first() const { return -1; }
  int lastU() const { return width_ - 2; }
  int lastV() const { return height_ - 2; }
  bool contains(int u, int v) const { return u >= -1 && v >= -1 && u < width_ - 1 && v < height_ - 1; }
  std::uint8_t& at(int u, int v) { return pixels_[static_cast<std::size_t>((v + 1) * width_ + u + 1)]; }
  std::uint8_t at(int u, int v) const { return pixels_[static_cast<std::size_t>((v + 1) * width_ + u + 1)]; }
  int count() const { return static_cast<int>(std::count(pixels_.begin(), pixels_.end(), 1)); }

 private:
  int width_, height_;
  std::vector<std::uint8_t> pixels_;
};

/// The pixels with the same value in `mask` that hang together with (u, v).
Mask componentOf(const Mask& mask, int u, int v, bool diagonal, const Mask& empty) {
  Mask component = empty;
  std::vector<std::pair<int, int>> stack = {{u, v}};
  component.at(u, v) = 1;
  while (!stack.empty()) {
    const std::pair<int, int> at = stack.back();
    stack.pop_back();
    for (int dv = -1; dv <= 1; ++dv) {
      for (int du = -1; du <= 1; ++du) {
        const int next_u = at.first + du, next_v = at.second + dv;
        if ((!diagonal && du * dv != 0) || !mask.contains(next_u, next_v)) continue;
        if (component.at(next_u, next_v) != 0 || mask.at(next_u, next_v) != mask.at(u, v)) continue;
        component.at(next_u, next_v) = 1;
        stack.emplace_back(next_u, next_v);
      }
    }
  }
  return component;
}

/// All components of the pixels with a value.
std::vector<Mask> componentsOf(const Mask& mask, std::uint8_t value, bool diagonal, const Mask& empty) {
  std::vector<Mask> components;
  Mask done = empty;
  for (int v = mask.first(); v <= mask.lastV(); ++v) {
    for (int u = mask.first(); u <= mask.lastU(); ++u) {
      if (mask.at(u, v) != value || done.at(u, v) != 0) continue;
      components.push_back(componentOf(mask, u, v, diagonal, empty));
      for (int y = mask.first(); y <= mask.lastV(); ++y) {
        for (int x = mask.first(); x <= mask.lastU(); ++x) {
          if (components.back().at(x, y) != 0) done.at(x, y) = 1;
        }
      }
    }
  }
  return components;
}

}  // namespace

ReferenceOutline referenceOutline(const Segmentation& segmentation, int label, int min_area) {
  const int width = segmentation.width, height = segmentation.height;
  const Mask empty(width, height);
  Mask labelled = empty;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      labelled.at(u, v) = segmentation.labels[static_cast<std::size_t>(v * width + u)] == label ? 1 : 0;
    }
  }

  ReferenceOutline outline;
  std::vector<Mask> kept;
  Mask largest = empty;
  bool keeps_largest = false;
  for (const Mask& part : componentsOf(labelled, 1, false, empty)) {
    // What is not this part: round it, and its holes, with whatever lies in them.
    const Mask outside = componentOf(part, -1, -1, true, empty);
    Mask enclosed = empty;
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) enclosed.at(u, v) = outside.at(u, v) == 0 ? 1 : 0;
    }
    if (enclosed.count() > largest.count()) {
      largest = enclosed;
      keeps_largest = enclosed.count() >= min_area;
    }
    if (enclosed.count() < min_area) continue;
    outline.part_areas.push_back(enclosed.count());
    kept.push_back(enclosed);
    for (const Mask& hole : componentsOf(part, 0, true, empty)) {
      if (hole.at(-1, -1) != 0 || hole.count() < min_area) continue;
      outline.hole_areas.push_back(hole.count());
      kept.push_back(hole);
    }
  }
  if (!keeps_largest && largest.count() > 0) {
    outline.part_areas.push_back(largest.count());
    kept.push_back(largest);
  }
  std::sort(outline.part_areas.begin(), outline.part_areas.end(), std::greater<>());
  std::sort(outline.hole_areas.begin(), outline.hole_areas.end(), std::greater<>());

  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      std::uint8_t inside = 0;
      for (const Mask& mask : kept) inside = static_cast<std::uint8_t>(inside ^ mask.at(u, v));
      outline.inside.push_back(inside);
      const bool here = labelled.at(u, v) != 0, right = labelled.at(u + 1, v) != 0;
      const bool below = labelled.at(u, v + 1) != 0, beyond = labelled.at(u + 1, v + 1) != 0;
      outline.has_touching_corners |= here == beyond && right == below && here != right;
    }
  }
  return outline;
}

double distanceToBorder(const Segmentation& segmentation, int label, int u, int v) {
  const auto carries = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < segmentation.width && y < segmentation.height &&
           segmentation.labels[static_cast<std::size_t>(y * segmentation.width + x)] == label;
  };
  double nearest = 1e9;
  for (int y = 0; y <= segmentation.height; ++y) {
    for (int x = 0; x <= segmentation.width; ++x) {
      // The cracks above and to the left of pixel (x, y).
      const double along_x = std::max(std::abs(x - u) - 0.5, 0.0),
                   along_y = std::max(std::abs(y - v) - 0.5, 0.0);
      if (carries(x, y) != carries(x, y - 1)) nearest = std::min(nearest, std::hypot(along_x, y - 0.5 - v));
      if (carries(x, y) != carries(x - 1, y)) nearest = std::min(nearest, std::hypot(x - 0.5 - u, along_y));
    }
  }
  return nearest;
}

}  // namespace line_plane_segmentation
