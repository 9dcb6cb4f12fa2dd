// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/label_runs.h"

#include <algorithm>

#include "row_kernels.h"

namespace line_plane_segmentation {

void LabelRuns::clear() {
  runs.clear();
  row_begin.assign(1, 0);
}

void LabelRuns::addRow(const std::uint16_t* labels, int width) {
  const int row = static_cast<int>(row_begin.size()) - 1;
  const std::size_t words = (static_cast<std::size_t>(width) + 7) / 8;
  if (changes_.size() != words) changes_.assign(words, 0);
  std::uint8_t* changes = reinterpret_cast<std::uint8_t*>(changes_.data());
  markChanges(labels, width, changes);
  int first = 0;
  for (std::size_t word = 0; word < words; ++word) {
    if (changes_[word] == 0) continue;  // most labels are the same as eight pixels before
    const int end = std::min(width, static_cast<int>(word) * 8 + 8);
    for (int u = static_cast<int>(word) * 8; u < end; ++u) {
      if (changes[u] == 0) continue;
      runs.push_back({row, first, u, labels[first]});
      first = u;
    }
  }
  runs.push_back({row, first, width, labels[first]});
  row_begin.push_back(runs.size());
}

void LabelRuns::scan(const std::vector<std::uint16_t>& labels, int width, int height) {
  clear();
  for (int v = 0; v < height; ++v) {
    addRow(labels.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width), width);
  }
}

void LabelRuns::join() {
  std::size_t kept = 0;
  for (std::size_t row = 0; row + 1 < row_begin.size(); ++row) {
    const std::size_t begin = row_begin[row], end = row_begin[row + 1];
    row_begin[row] = kept;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin && runs[kept - 1].label == runs[i].label) {
        runs[kept - 1].last = runs[i].last;
      } else {
        runs[kept++] = runs[i];
      }
    }
  }
  runs.resize(kept);
  if (!row_begin.empty()) row_begin.back() = kept;
}

void LabelRuns::write(std::vector<std::uint16_t>& labels, int width) const {
  for (const LabelRun& run : runs) {
    std::uint16_t* row = labels.data() + static_cast<std::size_t>(run.row) * static_cast<std::size_t>(width);
    std::fill(row + run.first, row + run.last, run.label == kNoDepthLabel ? std::uint16_t{0} : run.label);
  }
}

}  // namespace line_plane_segmentation
