// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_segmenter.h"

#include <algorithm>
#include <array>

#include "line_plane_segmentation/outline.h"

namespace line_plane_segmentation {

struct PlaneSegmenter::Stages {
  Parameters parameters;
  std::vector<LineSegment> segments;
  std::vector<PlaneCandidate> candidates;
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

const Segmentation& PlaneSegmenter::segment(const DepthView& depth, const CameraIntrinsics&, StageObserver*) {
  Segmentation& result = stages_->result;
  result.width = depth.width;
  result.height = depth.height;
  result.labels.assign(static_cast<std::size_t>(depth.width) * static_cast<std::size_t>(depth.height), 0);
  result.planes.clear();
  return result;
}

}  // namespace line_plane_segmentation
