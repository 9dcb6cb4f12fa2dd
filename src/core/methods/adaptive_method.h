// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lines/line_growing.h"
#include "methods/method.h"
#include "planes/plane_clustering.h"
#include "planes/plane_continuation.h"
#include "refine/pixel_assignment.h"
#include "refine/region_cleanup.h"

namespace line_plane_segmentation {

/// The default method: the paper's stages with tolerances that follow the noise. Line segments grow in
/// inverse depth, candidates are crossings of segments, and candidates that segments connect grow into
/// planes.
class AdaptiveMethod final : public SegmentationMethod {
 public:
  void extractLines(Frame& frame) override;
  void detectCandidates(const Frame& frame) override;
  void extractPlanes(const Frame& frame, StageObserver& observer, LabeledPlanes& planes) override;
  void refine(const Frame& frame, LabeledPlanes& planes) override;
  void describe(const Frame& frame, std::vector<LineSegment>& segments,
                std::vector<PlaneCandidate>& candidates) const override;

 private:
  ScanlineSet rows_, columns_;
  WindowSummer window_summer_;
  NoiseMeter noise_meter_;
  double distortion_ = 1.0;  // of the frame, as a multiple of its noise
  LineGrower line_grower_;
  CandidateGrid grid_;
  CrossingDetector crossing_detector_;
  PlaneClusterer clusterer_;
  std::vector<PlaneCluster> clusters_;
  std::vector<int> cluster_at_;  // index in clusters_ per crossing, -1 if none
  PixelAssigner assigner_;
  PlaneContinuation continuation_;
  std::vector<int> plane_of_;  // index in clusters_ per cluster, -1 for no plane
  RegionCleaner cleaner_;
};

}  // namespace line_plane_segmentation
