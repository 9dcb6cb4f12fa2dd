// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation {

/// Stands in a label image where a pixel has no depth, until the image is cleaned.
constexpr std::uint16_t kNoDepthLabel = 65535;

/// Neighbouring pixels of one row with the same label: columns first to last - 1.
struct LabelRun {
  int row, first, last;
  std::uint16_t label;

  int pixels() const { return last - first; }
};

/// A label image as runs, row by row, in each from the left; together they cover every pixel.
struct LabelRuns {
  std::vector<LabelRun> runs;
  std::vector<std::size_t>
      row_begin;  ///< index of each row's first run, and behind the last row the number of runs

  /// Starts an empty image; its rows are then added from the top.
  void clear();

  /// Adds a row of `width` labels, at least one.
  void addRow(const std::uint16_t* labels, int width);

  /// Joins A 0 A to A in the last row, for planes A, where 0 is at most `max_pixels` wide and
  /// `is_like(before, 0, after)` holds: noise, which would otherwise make most of the runs.
  template <typename Predicate>
  void joinOverSpeckles(int max_pixels, Predicate&& is_like);

  /// All rows of a label image at once.
  void scan(const std::vector<std::uint16_t>& labels, int width, int height);

  /// Gives each run i the label `label_of(i, run)`, and makes one run of neighbours in a row that come to
  /// carry the same.
  template <typename Function>
  void join(Function&& label_of);

  /// Writes the runs' labels into an image of their size.
  void write(std::vector<std::uint16_t>& labels, int width) const;

 private:
  std::vector<std::uint8_t> changes_;  // of a row: 1 where another label begins, else 0
  std::vector<int> columns_;           // of a row: where another label begins
};

template <typename Predicate>
void LabelRuns::joinOverSpeckles(int max_pixels, Predicate&& is_like) {
  const std::size_t begin = row_begin[row_begin.size() - 2];
  std::size_t kept = begin;
  for (std::size_t i = begin; i < runs.size(); ++i) {
    if (kept != i) runs[kept] = runs[i];
    ++kept;
    if (kept < begin + 3) continue;
    LabelRun& before = runs[kept - 3];
    const LabelRun &speckle = runs[kept - 2], &after = runs[kept - 1];
    // In one condition, which seldom holds: one by one, they are hard to predict.
    const bool is_speckle = (before.label == after.label) & (before.label != kNoDepthLabel) &
                            (speckle.label == 0) & (speckle.pixels() <= max_pixels);
    if (!is_speckle || !is_like(before, speckle, after)) continue;
    before.last = after.last;
    kept -= 2;
  }
  runs.resize(kept);
  row_begin.back() = kept;
}

template <typename Function>
void LabelRuns::join(Function&& label_of) {
  std::size_t kept = 0;
  for (std::size_t row = 0; row + 1 < row_begin.size(); ++row) {
    const std::size_t begin = row_begin[row], end = row_begin[row + 1];
    row_begin[row] = kept;
    int first = 0, label = -1;
    for (std::size_t i = begin; i < end; ++i) {
      const LabelRun run = runs[i];
      const std::uint16_t new_label = label_of(i, run);
      const bool is_another = new_label != label;
      first = is_another ? run.first : first;
      label = new_label;
      kept += is_another ? 1U : 0U;
      // Stored one by one: a copy of the whole would wait for its parts.
      LabelRun& joined = runs[kept - 1];
      joined.row = run.row;
      joined.first = first;
      joined.last = run.last;
      joined.label = new_label;
    }
  }
  runs.resize(kept);
  if (!row_begin.empty()) row_begin.back() = kept;
}

/// Calls `visit(a, b)` for each two runs that lie above each other in some columns, a above b.
template <typename Visitor>
void forEachVerticalContact(const LabelRuns& image, Visitor&& visit) {
  if (image.row_begin.size() < 3) return;
  // The last runs of two rows end in the same column, so both rows then go on to the next.
  for (std::size_t a = 0, b = image.row_begin[1]; b < image.runs.size();) {
    const int last_above = image.runs[a].last, last_below = image.runs[b].last;
    visit(a, b);
    a += last_above <= last_below ? 1U : 0U;
    b += last_below <= last_above ? 1U : 0U;
  }
}

}  // namespace line_plane_segmentation
