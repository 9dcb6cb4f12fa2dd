// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/label_runs.h"

#include <algorithm>

#include "row_kernels.h"

namespace line_plane_segmentation {

void LabelRuns::scan(const std::vector<std::uint16_t>& labels, int width, int height) {
  runs.clear();
  row_begin.clear();
  const std::size_t words = (static_cast<std::size_t>(width) + 7) / 8;
  changes_.assign(words, 0);
  for (int v = 0; v < height; ++v) {
    row_begin.push_back(runs.size());
    const std::uint16_t* row = labels.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width);
    std::uint8_t* changes = reinterpret_cast<std::uint8_t*>(changes_.data());
    markChanges(row, width, changes);
    int first = 0;
    for (std::size_t word = 0; word < words; ++word) {
      if (changes_[word] == 0) continue;
      const int end = std::min(width, static_cast<int>(word) * 8 + 8);
      for (int u = static_cast<int>(word) * 8; u < end; ++u) {
        if (changes[u] == 0) continue;
        runs.push_back({v, first, u, row[first]});
        first = u;
      }
    }
    runs.push_back({v, first, width, row[first]});
  }
  row_begin.push_back(runs.size());
}

void LabelRuns::write(std::vector<std::uint16_t>& labels, int width) const {
  for (const LabelRun& run : runs) {
    std::uint16_t* row = labels.data() + static_cast<std::size_t>(run.row) * static_cast<std::size_t>(width);
    std::fill(row + run.first, row + run.last, run.label == kNoDepthLabel ? std::uint16_t{0} : run.label);
  }
}

}  // namespace line_plane_segmentation
