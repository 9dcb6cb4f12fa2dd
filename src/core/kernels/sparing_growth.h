// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace line_plane_segmentation {

/// Makes room for so many elements. Grows by a quarter and not to twice the size: clutter has as many runs
/// and borders as pixels, and memory is bounded in bytes per pixel.
template <typename T>
void reserveSparingly(std::size_t needed, std::vector<T>& vector) {
  if (needed > vector.capacity()) vector.reserve(needed + needed / 4 + 1024);
}

/// Resizes to new elements. The old memory is freed before more is allocated.
template <typename T>
void resizeAnew(std::size_t size, std::vector<T>& vector) {
  vector.clear();
  if (vector.capacity() < size) std::vector<T>().swap(vector);
  vector.resize(size);
}

}  // namespace line_plane_segmentation
