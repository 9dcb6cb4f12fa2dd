// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "region_overlap.h"

namespace line_plane_segmentation {

/// Counts of classified regions, of one frame or summed over several. "Truth" is the ground truth.
struct HooverCounts {
  int required = 0;         ///< truth regions that must be found
  int labels = 0;           ///< label regions
  int correct = 0;          ///< truth regions found as one label region
  int over_segmented = 0;   ///< truth regions found as several label regions
  int under_segmented = 0;  ///< label regions that cover several truth regions
  int merged = 0;           ///< truth regions covered by under-segmented label regions
  int missed = 0;           ///< truth regions in no other class
  int noise = 0;            ///< label regions in no other class

  /// Truth regions that have a label region with the mutual overlap of "correct", also where the pieces
  /// beside it make them over-segmented by the rule below. At least `correct`.
  int one_to_one = 0;

  HooverCounts& operator+=(const HooverCounts& other);
};

/// Classifies regions after A. Hoover et al., "An experimental comparison of range image segmentation
/// algorithms", IEEE PAMI 18(7), 1996. With the tolerance T:
/// - correct: a truth region and a label region that share at least T of the pixels of each;
/// - over-segmented: a truth region and two or more label regions, each with at least T of its pixels
///   in it, which together hold at least T of its pixels;
/// - under-segmented: the same with truth and label exchanged;
/// - missed, noise: truth and label regions that are in none of these.
/// Where a region would be in several, the one whose overlaps are largest on average stays; of equals
/// correct before over- before under-segmented.
///
/// Truth regions under `min_pixels` are not required: they take no part, and a label region that
/// finds one correctly is no noise.
/// @param tolerance  T, above 0.5 (else regions could be matched twice), at most 1
HooverCounts classifyRegions(const RegionOverlaps& regions, double tolerance, std::int64_t min_pixels);

}  // namespace line_plane_segmentation
