// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_segmenter.h"

#include <algorithm>
#include <array>
#include <optional>

#include "line_plane_segmentation/candidate_detection.h"
#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/label_runs.h"
#include "line_plane_segmentation/line_extraction.h"
#include "line_plane_segmentation/outline.h"
#include "line_plane_segmentation/patch_clustering.h"
#include "line_plane_segmentation/pixel_assignment.h"
#include "line_plane_segmentation/plane_extraction.h"
#include "line_plane_segmentation/plane_measurement.h"
#include "line_plane_segmentation/region_cleanup.h"
#include "line_plane_segmentation/surface_patch.h"

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

class SilentObserver final : public StageObserver {
 public:
  void frameStarted() override {}
  void stageFinished(Stage) override {}
};

}  // namespace

struct PlaneSegmenter::Stages {
  Parameters parameters;
  DepthImage depth;
  ViewRays rays;
  LabelRuns runs;
  PlaneMeasurement measurement;
  OutlineTracer outlines;
  Segmentation result;

  // What lineSegments() and candidates() show; the adaptive method makes them only when asked.
  std::vector<LineSegment> segments;
  std::vector<PlaneCandidate> candidates;
  Parameters resolved;  // of the last frame
  bool is_described = true;

  // Method paper.
  LineExtractor line_extractor;
  PlaneExtractor plane_extractor;

  // Method adaptive.
  PatchDetector patch_detector;
  PatchLevels patches;
  std::vector<std::uint8_t> explained;
  PatchClusterer clusterer;
  std::vector<PatchCluster> clusters;
  std::vector<int> cluster_of;
  PixelAssigner assigner;
  RegionCleaner cleaner;
  std::vector<std::optional<PlaneEstimate>> estimates;  // of each label

  // Each fills `runs` with the labels that it found, and returns how many there are.
  int runPaper(const CameraIntrinsics& camera, StageObserver& observer);
  int runAdaptive(StageObserver& observer);
  void describe();
};

int PlaneSegmenter::Stages::runPaper(const CameraIntrinsics& camera, StageObserver& observer) {
  line_extractor.extract(depth, camera, resolved, segments);
  observer.stageFinished(Stage::kLines);
  detectCandidates(depth, rays, segments, resolved.candidates, candidates);
  observer.stageFinished(Stage::kCandidates);
  std::fill(result.labels.begin(), result.labels.end(), std::uint16_t{0});
  const int label_count = plane_extractor.extract(depth, rays, candidates, resolved, result.labels);
  runs.scan(result.labels, depth.width, depth.height);
  observer.stageFinished(Stage::kExtraction);
  return label_count;
}

int PlaneSegmenter::Stages::runAdaptive(StageObserver& observer) {
  patch_detector.detect(depth, rays, resolved, patches.coarse);
  is_described = false;
  observer.stageFinished(Stage::kLines);
  clusterer.clusterCoarse(patches.coarse, resolved, explained);
  patch_detector.refine(depth, rays, resolved, explained, patches);
  clusterer.cluster(depth, rays, patches, resolved, clusters, cluster_of);
  observer.stageFinished(Stage::kCandidates);
  assigner.assign(depth, rays, patches, clusters, cluster_of, resolved, runs);
  observer.stageFinished(Stage::kExtraction);
  const int label_count = cleaner.clean(depth, rays, clusters, resolved, runs);
  for (int label = 1; label <= label_count; ++label) {
    const PatchCluster& cluster = clusters[static_cast<std::size_t>(cleaner.clusterOf(label))];
    estimates.push_back(cluster.is_narrow ? std::nullopt : std::make_optional(estimatePlane(cluster)));
  }
  return label_count;
}

void PlaneSegmenter::Stages::describe() {
  if (!is_described) describePatches(patches.coarse, rays, resolved, segments, candidates);
  is_described = true;
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

const std::vector<LineSegment>& PlaneSegmenter::lineSegments() const {
  stages_->describe();
  return stages_->segments;
}

const std::vector<PlaneCandidate>& PlaneSegmenter::candidates() const {
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
  s.is_described = true;
  s.estimates.clear();
  if (view.empty() || !camera.isValid()) {
    std::fill(s.result.labels.begin(), s.result.labels.end(), std::uint16_t{0});
    return s.result;
  }

  s.resolved = resolve(s.parameters, view.width);
  const DepthRange range{static_cast<float>(s.resolved.scanlines.min_range),
                         static_cast<float>(s.resolved.scanlines.max_range)};
  s.result.valid_pixels = loadDepth(view, range, s.depth);
  s.rays.compute(camera, view.width, view.height);

  const int label_count = s.resolved.method == Method::kPaper ? s.runPaper(camera, stage_observer)
                                                              : s.runAdaptive(stage_observer);
  s.measurement.measure(s.depth, s.rays, camera, label_count, s.resolved.extraction.min_plane_area, s.runs,
                        s.result, s.estimates);
  s.runs.write(s.result.labels, view.width);
  stage_observer.stageFinished(Stage::kRefinement);
  s.outlines.trace(camera, s.resolved.outlines, s.runs, s.result);
  stage_observer.stageFinished(Stage::kOutlines);
  return s.result;
}

}  // namespace line_plane_segmentation
