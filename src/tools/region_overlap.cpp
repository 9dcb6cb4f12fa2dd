// SPDX-License-Identifier: BSD-3-Clause
#include "region_overlap.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace line_plane_segmentation {
namespace {

using Sizes = std::map<std::uint16_t, std::int64_t>;

std::vector<CountedRegion> regionsOf(const Sizes& sizes) {
  std::vector<CountedRegion> regions;
  for (const auto& [value, pixels] : sizes) {
    if (value != 0) regions.push_back({value, pixels});
  }
  return regions;
}

std::size_t indexOf(const std::vector<CountedRegion>& regions, std::uint16_t value) {
  const auto at =
      std::lower_bound(regions.begin(), regions.end(), value,
                       [](const CountedRegion& region, std::uint16_t v) { return region.value < v; });
  return static_cast<std::size_t>(at - regions.begin());
}

using Counts = std::map<std::pair<std::uint16_t, std::uint16_t>, std::int64_t>;  // by truth and label

Counts countPairs(const std::uint16_t* truth, const std::uint16_t* labels, std::size_t pixels) {
  Counts counts;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= pixels; ++i) {  // runs of equal pairs: one search per run instead of per pixel
    if (i < pixels && truth[i] == truth[begin] && labels[i] == labels[begin]) continue;
    counts[{truth[begin], labels[begin]}] += static_cast<std::int64_t>(i - begin);
    begin = i;
  }
  return counts;
}

// Labels that are mere fringes of what is not to be judged, as the header defines them.
std::set<std::uint16_t> fringesIn(const Counts& counts, const Sizes& truth_sizes, const Sizes& label_sizes) {
  std::set<std::uint16_t> fringes;
  for (const auto& [values, count] : counts) {
    const auto [truth, label] = values;
    if (truth != kDoNotJudge) continue;
    const auto judged = label_sizes.find(label);
    if (judged != label_sizes.end() && count > judged->second) fringes.insert(label);
  }
  for (const auto& [values, count] : counts) {
    const auto [truth, label] = values;
    if (truth == 0 || truth == kDoNotJudge) continue;
    if (2 * count > truth_sizes.at(truth)) fringes.erase(label);
  }
  return fringes;
}

}  // namespace

RegionOverlaps countOverlaps(const std::uint16_t* truth, const std::uint16_t* labels, std::size_t pixels) {
  const Counts counts = countPairs(truth, labels, pixels);
  Sizes truth_sizes;
  Sizes label_sizes;
  for (const auto& [values, count] : counts) {
    if (values.first == kDoNotJudge) continue;
    truth_sizes[values.first] += count;
    label_sizes[values.second] += count;
  }
  for (const std::uint16_t label : fringesIn(counts, truth_sizes, label_sizes)) label_sizes.erase(label);

  RegionOverlaps result{regionsOf(truth_sizes), regionsOf(label_sizes), {}};
  for (const auto& [values, count] : counts) {
    const auto [truth_value, label] = values;
    if (truth_value == 0 || truth_value == kDoNotJudge || label == 0 || label_sizes.count(label) == 0)
      continue;
    result.overlaps.push_back({indexOf(result.truth, truth_value), indexOf(result.labels, label), count});
  }
  return result;
}

}  // namespace line_plane_segmentation
