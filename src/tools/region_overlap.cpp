// SPDX-License-Identifier: BSD-3-Clause
#include "region_overlap.h"

#include <algorithm>
#include <map>
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

}  // namespace

RegionOverlaps countOverlaps(const std::uint16_t* truth, const std::uint16_t* labels, std::size_t pixels) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::int64_t> shared;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (truth[i] != kDoNotJudge) ++shared[{truth[i], labels[i]}];
  }

  Sizes truth_sizes;
  Sizes label_sizes;
  for (const auto& [values, count] : shared) {
    truth_sizes[values.first] += count;
    label_sizes[values.second] += count;
  }

  RegionOverlaps result{regionsOf(truth_sizes), regionsOf(label_sizes), {}};
  for (const auto& [values, count] : shared) {
    if (values.first == 0 || values.second == 0) continue;
    result.overlaps.push_back(
        {indexOf(result.truth, values.first), indexOf(result.labels, values.second), count});
  }
  return result;
}

}  // namespace line_plane_segmentation
