// SPDX-License-Identifier: BSD-3-Clause
#include "methods/adaptive_method.h"

#include <algorithm>

namespace line_plane_segmentation {
namespace {

// Bounds of the measured noise, as a multiple of the model. The model is the lower one: an image can be
// smoother than its sensor's noise, as in-painted ones are, but its errors are not smaller.
constexpr double kMinNoiseRatio = 1.0, kMaxNoiseRatio = 4.0;

// Bounds of the measured distortion, as multiples of the noise. In a cluttered image few pieces of a scanline
// are straight, and the ratio measures the scene: from 4 to 5 times the noise, the distortion falls back
// to 1.
constexpr double kMaxDistortion = 2.0, kClutter = 6.0;

// Length of the pieces from which distortion is measured, as a fraction of the width of a Kinect's image: the
// same part of the view whatever the scanlines are.
constexpr double kDistortionLength = 1.0 / 16;

}  // namespace

void AdaptiveMethod::extractLines(Frame& frame) {
  Parameters& p = frame.parameters;
  window_summer_.sum(frame.depth, frame.rays, p.scanlines.scanline_spacing, p.lines.line_window, rows_,
                     columns_);
  const bool is_measured = !(p.noise.scale > 0.0);
  const double scale =
      is_measured ? std::clamp(noise_meter_.ratio(rows_, columns_, p.noise), kMinNoiseRatio, kMaxNoiseRatio)
                  : p.noise.scale;
  p.noise.floor *= scale;
  p.noise.growth *= scale;
  const double ratio = is_measured ? noise_meter_.distortionRatio(rows_, columns_, p.noise,
                                                                  kDistortionLength * frame.kinect_width)
                                   : 1.0;
  distortion_ = std::clamp(std::min(ratio, kClutter - ratio), 1.0, kMaxDistortion);
  // Candidates deviate from their plane by the distortion. The pixels of a small plane have to lie in it as
  // before: their bound is in units of the noise.
  p.patches.patch_noise_factor *= distortion_;
  p.clusters.max_curvedness /= distortion_ * distortion_;
  line_grower_.grow(frame.rays.y, p, rows_);
  line_grower_.grow(frame.rays.x, p, columns_);
}

void AdaptiveMethod::detectCandidates(const Frame& frame) {
  crossing_detector_.detect(frame.rays, rows_, columns_, frame.parameters, grid_);
}

void AdaptiveMethod::extractPlanes(const Frame& frame, StageObserver&, LabeledPlanes& planes) {
  clusterer_.cluster(frame.depth, frame.rays, grid_, frame.parameters, distortion_, clusters_, cluster_at_);
  assigner_.assign(frame.depth, frame.rays, grid_, clusters_, cluster_at_, frame.parameters, planes.runs);
  continuation_.find(frame.rays, grid_, clusters_, cluster_at_, frame.parameters, plane_of_);
  planes.runs.join([this](std::size_t, const LabelRun& run) {
    const bool is_plane = run.label != 0 && run.label != kNoDepthLabel;
    return is_plane ? static_cast<std::uint16_t>(plane_of_[run.label - 1U] + 1) : run.label;
  });
}

void AdaptiveMethod::refine(const Frame& frame, LabeledPlanes& planes) {
  planes.label_count = cleaner_.clean(frame.depth, frame.rays, clusters_, frame.parameters, planes.runs);
  planes.estimates.clear();
  for (int label = 1; label <= planes.label_count; ++label) {
    const PlaneCluster& cluster = clusters_[cleaner_.clusterOf(label)];
    planes.estimates.push_back(cluster.is_narrow ? std::nullopt : std::make_optional(estimatePlane(cluster)));
  }
}

void AdaptiveMethod::describe(const Frame& frame, std::vector<LineSegment>& segments,
                              std::vector<PlaneCandidate>& candidates) const {
  segments.clear();
  describeSegments(frame.depth, frame.rays, rows_, segments);
  describeSegments(frame.depth, frame.rays, columns_, segments);
  candidates.clear();
  for (const CrossingCandidate& candidate : grid_.candidates) candidates.push_back(candidate.describe());
}

}  // namespace line_plane_segmentation
