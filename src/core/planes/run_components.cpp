// SPDX-License-Identifier: BSD-3-Clause
#include "planes/run_components.h"

#include <algorithm>
#include <utility>

#include "kernels/row_kernels.h"
#include "kernels/sparing_growth.h"

namespace line_plane_segmentation {
namespace {

bool touches(const PixelRun& above, const PixelRun& below, const std::uint8_t* links_above) {
  const int last = std::min(above.last, below.last);
  for (int u = std::max(above.first, below.first); u < last; ++u) {
    if ((links_above[u] & kLinkDown) != 0) return true;
  }
  return false;
}

}  // namespace

void RunComponents::clear() {
  runs_.clear();
  parent_.clear();
  pixels_.clear();
  row_ = -1;
  row_begin_ = above_begin_ = above_end_ = 0;
}

int RunComponents::find(int run) {
  while (parent_[run] != run) {
    int& parent = parent_[run];
    parent = parent_[parent];
    run = parent;
  }
  return run;
}

void RunComponents::add(const PixelRun& run, const std::uint8_t* links_above) {
  const int index = static_cast<int>(runs_.size());
  if (run.row != row_) {
    const bool follows = run.row == row_ + 1;
    above_begin_ = follows ? row_begin_ : index;
    above_end_ = index;
    row_begin_ = index;
    row_ = run.row;
  }
  const std::size_t needed = runs_.size() + 1;
  reserveSparingly(needed, runs_);
  reserveSparingly(needed, parent_);
  reserveSparingly(needed, pixels_);
  runs_.push_back(run);
  parent_.push_back(index);
  pixels_.push_back(run.last - run.first);
  if (links_above == nullptr) return;

  while (above_begin_ < above_end_ && runs_[above_begin_].last <= run.first) ++above_begin_;
  for (int above = above_begin_; above < above_end_ && runs_[above].first < run.last; ++above) {
    if (!touches(runs_[above], run, links_above)) continue;
    int a = find(above), b = find(index);
    if (a == b) continue;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    pixels_[a] += pixels_[b];
  }
}

int RunComponents::componentAt(int u, int v) {
  const auto run =
      std::lower_bound(runs_.begin(), runs_.end(), std::make_pair(v, u),
                       [](const PixelRun& r, auto at) { return std::make_pair(r.row, r.last - 1) < at; });
  if (run == runs_.end() || run->row != v || run->first > u) return -1;
  return find(static_cast<int>(run - runs_.begin()));
}

const std::vector<PixelRun>& RunComponents::runsOf(int component) {
  found_.clear();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (find(static_cast<int>(i)) == component) found_.push_back(runs_[i]);
  }
  return found_;
}

}  // namespace line_plane_segmentation
