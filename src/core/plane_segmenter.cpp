// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_segmenter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "depth/hole_filling.h"
#include "depth/hole_kernels.h"
#include "methods/adaptive_method.h"
#include "methods/paper_method.h"
#include "outline/outline.h"
#include "refine/plane_measurement.h"

namespace line_plane_segmentation {
namespace {

void clear(const DepthView& view, Segmentation& result) {
  result.width = std::max(0, view.width);
  result.height = std::max(0, view.height);
  result.labels.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
  result.planes.clear();
  result.rings.clear();
  result.vertices.clear();
  result.valid_pixels = 0;
  result.assigned_pixels = 0;
}

// The labels of an image without planes. Otherwise every label is written.
void clearLabels(Segmentation& result) {
  std::fill(result.labels.begin(), result.labels.end(), std::uint16_t{0});
}

class SilentObserver final : public StageObserver {
 public:
  void frameStarted() override {}
  void stageFinished(Stage) override {}
};

}  // namespace

int kinectWidthOf(const CameraIntrinsics& camera, int width, int height) {
  constexpr double kKinectWidth = 640.0, kKinectFocalLength = 525.0, kMaxPerDiagonal = 1.2;
  const double same_angle = kKinectWidth / kKinectFocalLength * std::sqrt(camera.fx * camera.fy);
  const double bound = kMaxPerDiagonal * std::hypot(width, height);
  return std::max(1, static_cast<int>(std::lround(std::min(same_angle, bound))));
}

struct PlaneSegmenter::Stages {
  Parameters parameters;
  Frame frame;
  HoleFiller hole_filler;
  bool is_perforated = false;
  PaperMethod paper;
  AdaptiveMethod adaptive;
  LabeledPlanes planes;
  PlaneMeasurement measurement;
  OutlineTracer outlines;
  Segmentation result;

  // Of the last frame; described when they are read.
  const SegmentationMethod* described_method = nullptr;
  std::vector<LineSegment> segments;
  std::vector<PlaneCandidate> candidates;

  void load(const DepthView& view, const CameraIntrinsics& camera);
  bool run(SegmentationMethod& method, StageObserver& observer);
  void refine(SegmentationMethod& method);
  void traceOutlines();
  void describe();
};

// Reads the depth, and prepares all that the stages of a method work on.
void PlaneSegmenter::Stages::load(const DepthView& view, const CameraIntrinsics& camera) {
  frame.camera = camera;
  const DepthRange range{static_cast<float>(parameters.scanlines.min_range),
                         static_cast<float>(parameters.scanlines.max_range)};
  result.valid_pixels = loadDepth(view, range, frame.depth);
  frame.rays.compute(camera, view.width, view.height);
  frame.kinect_width = kinectWidthOf(camera, view.width, view.height);
  const bool is_paper = parameters.method == Method::kPaper;
  frame.parameters = resolve(parameters, is_paper ? view.width : frame.kinect_width);
  is_perforated = !is_paper && hole_filler.fill(frame.parameters, frame.depth);
}

void PlaneSegmenter::Stages::refine(SegmentationMethod& method) {
  method.refine(frame, planes);
  if (is_perforated) hole_filler.removeFilled(frame.depth);  // only measured depth is part of a plane
  measurement.measure(frame.depth, frame.rays, frame.camera, planes.label_count,
                      frame.parameters.extraction.min_plane_area, planes.runs, result, planes.estimates,
                      is_perforated);
  planes.runs.write(result.labels, frame.depth.width);
}

// Outlines go round what was filled in; labels are of measured pixels only.
void PlaneSegmenter::Stages::traceOutlines() {
  outlines.trace(frame.camera, frame.parameters.outlines, planes.runs, result);
  if (is_perforated) clearWithoutDepth(frame.depth.z.data(), result.labels.size(), result.labels.data());
}

// @return false if the observer requested a stop
bool PlaneSegmenter::Stages::run(SegmentationMethod& method, StageObserver& observer) {
  const auto finish = [&observer](Stage stage) {
    observer.stageFinished(stage);
    return !observer.isStopRequested();
  };
  method.extractLines(frame);
  if (!finish(Stage::kLines)) return false;
  method.detectCandidates(frame);
  if (!finish(Stage::kCandidates)) return false;
  method.extractPlanes(frame, observer, planes);
  if (!finish(Stage::kExtraction)) return false;
  refine(method);
  described_method = &method;
  if (!finish(Stage::kRefinement)) return false;
  traceOutlines();
  return finish(Stage::kOutlines);
}

void PlaneSegmenter::Stages::describe() {
  if (described_method == nullptr) return;
  described_method->describe(frame, segments, candidates);
  described_method = nullptr;
}

const char* nameOf(Stage stage) {
  constexpr std::array<const char*, kStageCount> kNames = {"lines", "candidates", "extraction", "refinement",
                                                           "outlines"};
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

const std::vector<LineSegment>& PlaneSegmenter::lineSegments() {
  stages_->describe();
  return stages_->segments;
}

const std::vector<PlaneCandidate>& PlaneSegmenter::candidates() {
  stages_->describe();
  return stages_->candidates;
}

const Segmentation& PlaneSegmenter::segment(const DepthView& view, const CameraIntrinsics& camera,
                                            StageObserver* observer) {
  Stages& s = *stages_;
  SilentObserver silent;
  StageObserver& stage_observer = observer != nullptr ? *observer : silent;
  stage_observer.frameStarted();
  clear(view, s.result);
  s.segments.clear();
  s.candidates.clear();
  s.described_method = nullptr;
  if (view.empty() || !camera.isValid()) {
    clearLabels(s.result);
    return s.result;
  }

  s.load(view, camera);
  SegmentationMethod& method = s.parameters.method == Method::kPaper
                                   ? static_cast<SegmentationMethod&>(s.paper)
                                   : static_cast<SegmentationMethod&>(s.adaptive);
  if (!s.run(method, stage_observer)) {
    s.described_method = nullptr;
    clear(view, s.result);
    clearLabels(s.result);
  }
  return s.result;
}

}  // namespace line_plane_segmentation
