// SPDX-License-Identifier: BSD-3-Clause
#include "label_anchor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace line_plane_segmentation {
namespace {

constexpr int kCellsPerRow = 80;

// Label image of low resolution, with a margin of cells of label 0, and a distance transform of it.
class CellGrid {
 public:
  explicit CellGrid(const Segmentation& segmentation)
      : side_(std::max(1, segmentation.width / kCellsPerRow)),
        columns_(segmentation.width / side_ + 2),
        rows_(segmentation.height / side_ + 2),
        labels_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0),
        distances_(labels_.size(), 0) {
    for (int r = 1; r <= rows_ - 2; ++r) {
      for (int c = 1; c <= columns_ - 2; ++c) labels_[indexOf(c, r)] = labelOfCell(segmentation, c, r);
    }
    for (int r = 1; r <= rows_ - 2; ++r) {
      for (int c = 1; c <= columns_ - 2; ++c) distances_[indexOf(c, r)] = rows_ + columns_;
    }
    // Two-pass distance transform (8-neighbourhood): steps from each cell to the nearest cell of another
    // label.
    for (int r = 1; r <= rows_ - 2; ++r) {
      for (int c = 1; c <= columns_ - 2; ++c) relax(c, r, {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}});
    }
    for (int r = rows_ - 2; r >= 1; --r) {
      for (int c = columns_ - 2; c >= 1; --c) relax(c, r, {{1, 0}, {1, 1}, {0, 1}, {-1, 1}});
    }
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::uint16_t label(int c, int r) const { return labels_[indexOf(c, r)]; }
  int distance(int c, int r) const { return distances_[indexOf(c, r)]; }
  int middlePixel(int cell) const { return (cell - 1) * side_ + side_ / 2; }

 private:
  struct Offset {
    int c, r;
  };

  std::size_t indexOf(int c, int r) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
  }

  // Label of more than half of the cell's samples by Boyer-Moore majority vote, else 0.
  std::uint16_t labelOfCell(const Segmentation& segmentation, int c, int r) const {
    const std::array<int, 3> offsets = {side_ / 4, side_ / 2, side_ * 3 / 4};
    std::uint16_t majority = 0;
    int vote_count = 0;
    for (const int y : offsets) {
      for (const int x : offsets) {
        const int pixel = ((r - 1) * side_ + y) * segmentation.width + (c - 1) * side_ + x;
        const std::uint16_t label = segmentation.labels[pixel];
        if (vote_count == 0) majority = label;
        vote_count += label == majority ? 1 : -1;
      }
    }
    return vote_count > 0 ? majority : std::uint16_t{0};
  }

  void relax(int c, int r, std::initializer_list<Offset> neighbours) {
    int& distance = distances_[indexOf(c, r)];
    for (const Offset& offset : neighbours) {
      const std::size_t neighbour = indexOf(c + offset.c, r + offset.r);
      const bool same = labels_[neighbour] == label(c, r);
      distance = std::min(distance, same ? distances_[neighbour] + 1 : 1);
    }
  }

  int side_;
  int columns_;
  int rows_;
  std::vector<std::uint16_t> labels_;
  std::vector<int> distances_;  // [cells] to the nearest cell of another label, at least 1
};

// Cells of one plane: count, sums of coordinates, and largest distance to the border.
struct PlaneCells {
  int count = 0;
  long sum_c = 0;
  long sum_r = 0;
  int max_distance = 0;
};

std::vector<PlaneCells> cellsOfPlanes(const CellGrid& grid, std::size_t plane_count) {
  std::vector<PlaneCells> cells(plane_count + 1);
  for (int r = 1; r <= grid.rows() - 2; ++r) {
    for (int c = 1; c <= grid.columns() - 2; ++c) {
      PlaneCells& plane = cells[grid.label(c, r)];
      ++plane.count;
      plane.sum_c += c;
      plane.sum_r += r;
      plane.max_distance = std::max(plane.max_distance, grid.distance(c, r));
    }
  }
  return cells;
}

}  // namespace

std::vector<LabelAnchor> labelAnchors(const Segmentation& segmentation) {
  constexpr double kMinDistanceRatio = 0.8;  // fraction of the largest distance to the border
  const CellGrid grid(segmentation);
  const std::vector<PlaneCells> cells = cellsOfPlanes(grid, segmentation.planes.size());

  std::vector<LabelAnchor> anchors(segmentation.planes.size());
  std::vector<long> least_squared_offset(anchors.size(), std::numeric_limits<long>::max());
  for (int r = 1; r <= grid.rows() - 2; ++r) {
    for (int c = 1; c <= grid.columns() - 2; ++c) {
      const std::uint16_t label = grid.label(c, r);
      const PlaneCells& plane = cells[label];
      const int distance = grid.distance(c, r);
      if (label == 0 || distance < kMinDistanceRatio * plane.max_distance) continue;
      const long dc = c - plane.sum_c / plane.count;
      const long dr = r - plane.sum_r / plane.count;
      const std::size_t k = label - std::size_t{1};
      if (dc * dc + dr * dr >= least_squared_offset[k]) continue;
      least_squared_offset[k] = dc * dc + dr * dr;
      anchors[k] = {true, grid.middlePixel(c), grid.middlePixel(r)};
    }
  }
  return anchors;
}

}  // namespace line_plane_segmentation
