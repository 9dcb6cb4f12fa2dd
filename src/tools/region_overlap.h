// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation {

/// In a truth image: a pixel that is not to be judged. 0 is no region, in both images.
constexpr std::uint16_t kDoNotJudge = 65535;

/// One region of a truth or label image: all pixels of one value, connected or not.
struct CountedRegion {
  std::uint16_t value = 0;
  std::int64_t pixels = 0;  ///< those to be judged
};

/// Pixels that a truth region and a label region share.
struct Overlap {
  std::size_t truth = 0;  ///< index in RegionOverlaps::truth
  std::size_t label = 0;  ///< index in RegionOverlaps::labels
  std::int64_t pixels = 0;
};

/// All that the measures need to know of a truth image and a label image of the same scene.
///
/// Pixels that are not to be judged are taken out of both; a region without others does not exist. Nor does a
/// label region that lies mostly on such pixels and holds no more than half of any truth region: what is
/// left of it is the fringe of something that nobody judged (as in PQ, Kirillov et al. 2019).
struct RegionOverlaps {
  std::vector<CountedRegion> truth;   ///< by rising value
  std::vector<CountedRegion> labels;  ///< by rising value
  std::vector<Overlap> overlaps;      ///< pairs that share pixels, by rising truth, then label
};

/// Counts the regions of two images of `pixels` pixels each.
RegionOverlaps countOverlaps(const std::uint16_t* truth, const std::uint16_t* labels, std::size_t pixels);

}  // namespace line_plane_segmentation
