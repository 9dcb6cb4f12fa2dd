// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "region_overlap.h"

namespace line_plane_segmentation {

/// Scores by intersection over union (IoU), of one frame or summed over several. Counts are summed, so each
/// region has the same weight, and in covering() each pixel.
///
/// A truth region and a label region match if their IoU is above 0.5; no region has two matches then.
/// Ground-truth regions below the size limit are not required: they are not counted, and a label region that
/// matches one of them is neither matched nor false.
struct IouScores {
  int required = 0;                  ///< truth regions that are to be found
  int matched = 0;                   ///< of these, those with a match
  int false_labels = 0;              ///< label regions that match no truth region
  double matched_iou_sum = 0.0;      ///< IoU of the matches
  double best_iou_sum = 0.0;         ///< of each required region, its largest IoU with any label region
  double covered_pixels = 0.0;       ///< of each required region, its pixels times that IoU
  std::int64_t required_pixels = 0;  ///< of the required regions

  IouScores& operator+=(const IouScores& other);

  // All from 0 to 1. NaN if there is no required region or no label region.
  double precision() const;        ///< label regions that match
  double recall() const;           ///< required regions that are matched
  double f1() const;               ///< harmonic mean of both
  double meanIou() const;          ///< over the required regions, of their best IoU
  double matchedIou() const;       ///< over the matches; 0 if there are none
  double panopticQuality() const;  ///< PQ = F1 times matchedIou()
  double covering() const;  ///< best IoU, over the pixels of the required regions (Arbelaez et al. 2011)
};

/// Scores one frame. Truth regions with fewer than `min_pixels` pixels are not required.
IouScores scoreIou(const RegionOverlaps& regions, std::int64_t min_pixels);

}  // namespace line_plane_segmentation
