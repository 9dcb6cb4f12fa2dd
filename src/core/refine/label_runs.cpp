// SPDX-License-Identifier: BSD-3-Clause
#include "refine/label_runs.h"

#include <cstddef>

#include "kernels/multiversion.h"
#include "kernels/row_kernels.h"
#include "kernels/sparing_growth.h"

namespace line_plane_segmentation {

namespace {

// Most runs are short: each is written in whole blocks, whose excess the next run overwrites.
LPS_MULTIVERSION
void fillRun(std::uint16_t* to, std::uint16_t* last, std::uint16_t* end, std::uint16_t label) {
  constexpr std::ptrdiff_t kBlock = 32;
  for (; to < last && end - to >= kBlock; to += kBlock) {
    for (std::ptrdiff_t i = 0; i < kBlock; ++i) to[i] = label;
  }
  for (; to < last; ++to) *to = label;
}

}  // namespace

void LabelRuns::clear() {
  runs.clear();
  row_begin.assign(1, 0);
}

void LabelRuns::addRow(const std::uint16_t* labels, int width) {
  const int row = static_cast<int>(row_begin.size()) - 1;
  const std::size_t columns = static_cast<std::size_t>(width);
  if (columns_.size() != columns + kSpareColumns) {
    columns_.resize(columns + kSpareColumns);
    changes_.assign(columns + kMarkBlock, 0);
  }
  markChanges(labels, width, changes_.data());
  const int* const end = compactIndices(changes_.data(), width, columns_.data());
  const std::size_t needed = runs.size() + static_cast<std::size_t>(end - columns_.data()) + 1;
  reserveSparingly(needed, runs);
  LabelRun* run = runs.data() + runs.size();
  runs.resize(needed);
  int first = 0;
  const auto add = [&](int last) {
    run->row = row;
    run->first = first;
    run->last = last;
    run->label = labels[first];
    ++run;
    first = last;
  };
  for (const int* column = columns_.data(); column != end; ++column) add(*column);
  add(width);
  row_begin.push_back(runs.size());
}

void LabelRuns::scan(const std::vector<std::uint16_t>& labels, int width, int height) {
  clear();
  for (int v = 0; v < height; ++v) {
    addRow(labels.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width), width);
  }
}

void LabelRuns::write(std::vector<std::uint16_t>& labels, int width) const {
  std::uint16_t* const end = labels.data() + labels.size();
  for (const LabelRun& run : runs) {
    std::uint16_t* row = labels.data() + static_cast<std::size_t>(run.row) * static_cast<std::size_t>(width);
    fillRun(row + run.first, row + run.last, end, run.label);
  }
}

}  // namespace line_plane_segmentation
