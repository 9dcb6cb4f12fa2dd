// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_segmenter.h"

#include <algorithm>
#include <array>

#include "line_plane_segmentation/candidate_detection.h"
#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/line_extraction.h"
#include "line_plane_segmentation/outline.h"
#include "line_plane_segmentation/plane_extraction.h"
#include "line_plane_segmentation/plane_measurement.h"

namespace line_plane_segmentation {
namespace {

void clear(const DepthView& view, Segmentation& result) {
  result.width = std::max(0, view.width);
  result.height = std::max(0, view.height);
  result.labels.assign(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 0);
  result.planes.clear();
  result.rings.clear();
  result.vertices.clear();
  result.valid_pixels = 0;
  result.assigned_pixels = 0;
}

std::uint32_t countValid(const DepthImage& depth) {
  return static_cast<std::uint32_t>(
      std::count_if(depth.z.begin(), depth.z.end(), [](float z) { return z > 0.0F; }));
}

}  // namespace

struct PlaneSegmenter::Stages {
  Parameters parameters;
  DepthImage depth;
  ViewRays rays;
  LineExtractor line_extractor;
  std::vector<LineSegment> segments;
  std::vector<PlaneCandidate> candidates;
  PlaneExtractor extractor;
  PlaneMeasurement measurement;
  OutlineTracer outlines;
  Segmentation result;
};

const char* nameOf(Stage stage) {
  constexpr std::array<const char*, kStageCount> kNames = {"lines", "candidates", "extraction", "refinement", "outlines"};
  return kNames[static_cast<std::size_t>(stage)];
}

PlaneSegmenter::PlaneSegmenter(const Parameters& parameters) : stages_(std::make_unique<Stages>()) {
  setParameters(parameters);
}
PlaneSegmenter::~PlaneSegmenter() = default;
PlaneSegmenter::PlaneSegmenter(PlaneSegmenter&&) noexcept = default;
PlaneSegmenter& PlaneSegmenter::operator=(PlaneSegmenter&&) noexcept = default;

void PlaneSegmenter::setParameters(const Parameters& parameters) {
  stages_->parameters = parameters;
  sanitize(stages_->parameters);
}

const Parameters& PlaneSegmenter::parameters() const { return stages_->parameters; }
const std::vector<LineSegment>& PlaneSegmenter::lineSegments() const { return stages_->segments; }
const std::vector<PlaneCandidate>& PlaneSegmenter::candidates() const { return stages_->candidates; }

const Segmentation& PlaneSegmenter::segment(const DepthView& view, const CameraIntrinsics& camera,
                                            StageObserver* observer) {
  Stages& s = *stages_;
  const auto finished = [observer](Stage stage) {
    if (observer != nullptr) observer->stageFinished(stage);
  };
  if (observer != nullptr) observer->frameStarted();
  clear(view, s.result);
  s.segments.clear();
  s.candidates.clear();
  if (view.empty() || !camera.isValid()) return s.result;

  const Parameters parameters = resolve(s.parameters, view.width);
  const DepthRange range{static_cast<float>(parameters.scanlines.min_range),
                         static_cast<float>(parameters.scanlines.max_range)};
  loadDepth(view, range, s.depth);
  s.result.valid_pixels = countValid(s.depth);
  s.rays.compute(camera, view.width, view.height);

  s.line_extractor.extract(s.depth, camera, parameters, s.segments);
  finished(Stage::kLines);
  detectCandidates(s.depth, s.rays, s.segments, parameters.candidates, s.candidates);
  finished(Stage::kCandidates);
  const int label_count = s.extractor.extract(s.depth, s.rays, s.candidates, parameters, s.result.labels);
  finished(Stage::kExtraction);
  s.measurement.measure(s.depth, s.rays, camera, label_count, s.result);
  finished(Stage::kRefinement);
  s.outlines.trace(camera, parameters.outlines, s.result);
  finished(Stage::kOutlines);
  return s.result;
}

}  // namespace line_plane_segmentation
