// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "evaluation.h"
#include "frame_variant.h"

namespace line_plane_segmentation {

/// Interface of a method under evaluation.
class FrameSegmenter {
 public:
  virtual ~FrameSegmenter() = default;
  /// Distance between the samples of the method's grid on a frame of this size [px]. A grid phase shifts by
  /// half.
  virtual int gridSpacing(const LabelledFrame& frame, const FrameVariant& variant) const = 0;
  /// Segments a frame that is already turned and shifted.
  /// @return one label per pixel, 0 = no plane; valid until the next call
  virtual const std::vector<std::uint16_t>& segment(const LabelledFrame& frame,
                                                    const FrameVariant& variant) = 0;
};

/// Returns the rotated and shifted frame of a variant.
LabelledFrame viewOf(const LabelledFrame& frame, const FrameVariant& variant,
                     const FrameSegmenter& segmenter);

/// Ground-truth region with its results over all variants.
struct RegionRecord {
  std::string frame;
  std::uint16_t value = 0;  ///< in the ground truth
  std::int64_t pixels = 0;
  int found = 0;    ///< number of variants in which it is matched with an IoU above 0.5
  int correct = 0;  ///< number of variants in which it is correct by the rule of Hoover et al.
};

/// The scores of a set in one variant.
struct VariantScores {
  Scores scores;
  std::int64_t clutter_pixels = 0;            ///< valid depth, no plane in the ground truth
  std::int64_t clutter_pixels_in_planes = 0;  ///< of these, pixels with a label
};

/// A figure over the variants.
struct RobustFigure {
  double mean = 0.0;
  double spread = 0.0;  ///< standard deviation
};

/// The scores of a set over the variants.
struct RobustScores {
  std::size_t frames = 0;
  std::vector<VariantScores> variants;
  std::vector<RegionRecord> regions;  ///< regions that are required to be found

  RobustFigure correct() const;   ///< fraction of the regions, by the rule of Hoover et al.
  RobustFigure oneToOne() const;  ///< fraction of the regions with a label region of the mutual overlap
  RobustFigure recall() const;    ///< at an IoU above 0.5
  RobustFigure covering() const;
  RobustFigure precision() const;        ///< at an IoU above 0.5
  RobustFigure clutterInPlanes() const;  ///< fraction of the clutter's pixels

  /// Fraction of the regions that flip: found (IoU above 0.5) in some variants, but not in all.
  double flips() const;
  /// Fraction of the regions that are found in at least 20 % and at most 80 % of the variants.
  double uncertain() const;
};

/// Creates a segmenter. Called once per thread.
using MakeFrameSegmenter = std::function<std::unique_ptr<FrameSegmenter>()>;

/// Evaluates each frame in each variant, on all cores.
/// @param settings  tolerance and min_pixels are used
RobustScores evaluateRobustly(const std::vector<LabelledFrame>& frames,
                              const std::vector<FrameVariant>& variants,
                              const MakeFrameSegmenter& make_segmenter, const EvaluationSettings& settings);

}  // namespace line_plane_segmentation
