// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/line_segment.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_candidate.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// The stages of a frame, in their order.
enum class Stage { kLines, kCandidates, kExtraction, kRefinement, kOutlines };

constexpr int kStageCount = 5;

/// The stage's name as it stands in reports: "lines", "candidates", "extraction", "refinement", "outlines".
const char* nameOf(Stage stage);

/// Told as each stage of a frame ends: how a caller takes times, since the core reads no clock.
class StageObserver {
 public:
  virtual ~StageObserver() = default;
  virtual void frameStarted() = 0;
  virtual void stageFinished(Stage stage) = 0;
};

/// Finds the planes of a depth image with line primitives, after Zhang, Chen and Liu (2016).
///
/// The same input and parameters give the same result, bit by bit, whatever was seen before. After
/// the first frames of a size nothing is allocated. Not thread-safe: one segmenter for each thread.
class PlaneSegmenter {
 public:
  explicit PlaneSegmenter(const Parameters& parameters = {});
  ~PlaneSegmenter();
  PlaneSegmenter(PlaneSegmenter&&) noexcept;
  PlaneSegmenter& operator=(PlaneSegmenter&&) noexcept;

  /// Takes effect with the next frame. `parameters` are put in order by sanitize() first.
  void setParameters(const Parameters& parameters);
  const Parameters& parameters() const;

  /// Segments one image. An empty view, an invalid camera, or no depth at all gives no planes and
  /// labels that are all 0. The result is valid until the next call.
  const Segmentation& segment(const DepthView& depth, const CameraIntrinsics& camera,
                              StageObserver* observer = nullptr);

  /// The line segments of the last frame (the paper's Figure 4).
  const std::vector<LineSegment>& lineSegments() const;

  /// The candidates of the last frame, before extraction.
  const std::vector<PlaneCandidate>& candidates() const;

 private:
  struct Stages;
  std::unique_ptr<Stages> stages_;
};

}  // namespace line_plane_segmentation
