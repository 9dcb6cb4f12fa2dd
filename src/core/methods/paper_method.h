// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lines/line_extraction.h"
#include "methods/method.h"
#include "planes/plane_extraction.h"

namespace line_plane_segmentation {

/// The published method to the letter: line regression (Algorithm 1), candidates by PCA, recursive extraction
/// (Algorithm 2).
class PaperMethod final : public SegmentationMethod {
 public:
  void extractLines(Frame& frame) override;
  void detectCandidates(const Frame& frame) override;
  void extractPlanes(const Frame& frame, StageObserver& observer, LabeledPlanes& planes) override;
  void refine(const Frame&, LabeledPlanes&) override {}  // the paper leaves it as future work
  void describe(const Frame& frame, std::vector<LineSegment>& segments,
                std::vector<PlaneCandidate>& candidates) const override;

 private:
  LineExtractor line_extractor_;
  PlaneExtractor plane_extractor_;
  std::vector<LineSegment> segments_;
  std::vector<PlaneCandidate> candidates_;
  std::vector<std::uint16_t> labels_;
};

}  // namespace line_plane_segmentation
