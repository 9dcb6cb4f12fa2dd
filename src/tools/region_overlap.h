// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation {

/// Value of ground-truth pixels that are excluded from the evaluation. 0 is no region, in both images.
constexpr std::uint16_t kDoNotJudge = 65535;

/// Region of a ground-truth or label image: all pixels of one value, connected or not.
struct CountedRegion {
  std::uint16_t value = 0;
  std::int64_t pixels = 0;  ///< number of evaluated pixels
};

/// Number of common pixels of a ground-truth region and a label region.
struct Overlap {
  std::size_t truth = 0;  ///< index in RegionOverlaps::truth
  std::size_t label = 0;  ///< index in RegionOverlaps::labels
  std::int64_t pixels = 0;
};

/// Regions and overlaps of a ground-truth image and a label image; input of all scores.
///
/// Excluded pixels are removed from both images, and regions that consist of them. A label region that lies
/// mostly on excluded pixels and covers at most half of any ground-truth region is removed as well, because
/// it belongs to a surface that is not evaluated (as in PQ, Kirillov et al. 2019).
struct RegionOverlaps {
  std::vector<CountedRegion> truth;   ///< by rising value
  std::vector<CountedRegion> labels;  ///< by rising value
  std::vector<Overlap> overlaps;      ///< pairs that share pixels, by rising truth, then label
};

/// Counts the regions of two images of `pixels` pixels each.
RegionOverlaps countOverlaps(const std::uint16_t* truth, const std::uint16_t* labels, std::size_t pixels);

}  // namespace line_plane_segmentation
