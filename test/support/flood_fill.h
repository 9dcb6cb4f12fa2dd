// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace line_plane_segmentation {

/// The pixels that hang together with (u, v) over pixels side by side or one above the other, one by one over
/// a stack: 1 for each of them, 0 for the others, row by row.
/// @param is_member  (u, v) -> bool, whether a pixel can belong to the region
/// @param is_linked  (u, v, u_next, v_next) -> bool, whether one can step between two neighbours
template <typename IsMember, typename IsLinked>
std::vector<std::uint8_t> floodFill(int width, int height, int u, int v, IsMember&& is_member,
                                    IsLinked&& is_linked) {
  const auto index = [width](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  };
  std::vector<std::uint8_t> region(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  if (!is_member(u, v)) return region;
  std::vector<std::pair<int, int>> stack = {{u, v}};
  region[index(u, v)] = 1;
  while (!stack.empty()) {
    const std::pair<int, int> at = stack.back();
    stack.pop_back();
    const std::pair<int, int> neighbors[] = {{at.first - 1, at.second},
                                             {at.first + 1, at.second},
                                             {at.first, at.second - 1},
                                             {at.first, at.second + 1}};
    for (const std::pair<int, int>& next : neighbors) {
      if (next.first < 0 || next.first >= width || next.second < 0 || next.second >= height) continue;
      if (region[index(next.first, next.second)] != 0 || !is_member(next.first, next.second)) continue;
      if (!is_linked(at.first, at.second, next.first, next.second)) continue;
      region[index(next.first, next.second)] = 1;
      stack.push_back(next);
    }
  }
  return region;
}

}  // namespace line_plane_segmentation
