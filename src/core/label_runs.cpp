// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/label_runs.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "row_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kPadding =
    8;  // the 7 marks that appendMarked() reads behind a row, and its spare column

}  // namespace

void LabelRuns::clear() {
  runs.clear();
  row_begin.assign(1, 0);
}

void LabelRuns::addRow(const std::uint16_t* labels, int width) {
  const int row = static_cast<int>(row_begin.size()) - 1;
  const std::size_t padded = static_cast<std::size_t>(width) + kPadding;
  if (changes_.size() != padded) {
    changes_.assign(padded, 0);
    columns_.resize(padded);
  }
  markChanges(labels, width, changes_.data());
  const int* const end = appendMarked(changes_.data(), 0, width, columns_.data());
  // Grown by a quarter and not to twice the size: a cluttered VGA image has 100,000 runs, which are most of
  // the memory.
  const std::size_t needed = runs.size() + static_cast<std::size_t>(end - columns_.data()) + 1;
  if (needed > runs.capacity()) runs.reserve(needed + runs.size() / 4);
  int first = 0;
  for (const int* column = columns_.data(); column != end; ++column) {
    runs.push_back({row, first, *column, labels[first]});
    first = *column;
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
    LabelRun joined{};
    for (std::size_t i = begin; i < end; ++i) {
      // Without a branch: whether neighbours have come to be alike is hard to predict.
      const LabelRun& run = runs[i];
      const bool is_more = (i > begin) & (run.label == joined.label);
      joined = {run.row, is_more ? joined.first : run.first, run.last, run.label};
      kept += is_more ? 0 : 1;
      runs[kept - 1] = joined;
    }
  }
  runs.resize(kept);
  if (!row_begin.empty()) row_begin.back() = kept;
}

// Most runs are short: each is written in whole blocks, whose excess the next run overwrites.
void LabelRuns::write(std::vector<std::uint16_t>& labels, int width) const {
  constexpr std::ptrdiff_t kBlock = 8;
  std::uint16_t* const end = labels.data() + labels.size();
  for (const LabelRun& run : runs) {
    std::uint16_t* row = labels.data() + static_cast<std::size_t>(run.row) * static_cast<std::size_t>(width);
    std::uint16_t *to = row + run.first, *const last = row + run.last;
    const std::uint16_t label = run.label == kNoDepthLabel ? std::uint16_t{0} : run.label;
    std::array<std::uint16_t, kBlock> block;
    block.fill(label);
    for (; to < last && end - to >= kBlock; to += kBlock) std::memcpy(to, block.data(), sizeof(block));
    if (to < last) std::fill(to, last, label);
  }
}

}  // namespace line_plane_segmentation
