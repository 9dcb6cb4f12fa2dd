// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace line_plane_segmentation {

/// Neighbouring pixels of one row that belong together: columns first to last - 1.
struct PixelRun {
  int row, first, last;
};

/// Connected components of runs of pixels, by union-find: rows are added from the top, in each the runs from
/// the left.
class RunComponents {
 public:
  void clear();

  /// Adds a run. `links_above` are the link bits of the row above (null for the first row of the image).
  void add(const PixelRun& run, const std::uint8_t* links_above);

  /// The component of the run that holds pixel (u, v), or -1 if none does.
  int componentAt(int u, int v);

  int pixelCount(int component) const { return pixels_[component]; }

  /// The runs of a component, from the top.
  const std::vector<PixelRun>& runsOf(int component);

 private:
  int find(int run);

  std::vector<PixelRun> runs_;
  std::vector<int> parent_;
  std::vector<int> pixels_;  // of the component, at its root
  // Runs of the row above the one being added, and the first that can still touch.
  int row_ = -1;
  int row_begin_ = 0, above_begin_ = 0, above_end_ = 0;
  std::vector<PixelRun> found_;
};

}  // namespace line_plane_segmentation
