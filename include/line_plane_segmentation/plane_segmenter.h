// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Stages of the segmentation, in the order of execution.
enum class Stage { kLines, kCandidates, kExtraction, kRefinement, kOutlines };

constexpr int kStageCount = 5;

/// Returns the stage's name in reports: "lines", "candidates", "extraction", "refinement", "outlines".
const char* nameOf(Stage stage);

/// Interface that is called when a stage of a frame ends. The core reads no clock; a caller measures times
/// here.
class StageObserver {
 public:
  virtual ~StageObserver() = default;
  virtual void frameStarted() = 0;
  virtual void stageFinished(Stage stage) = 0;

  /// Returns true if the frame shall be given up. Polled after each stage and during long ones; may be called
  /// thousands of times per frame.
  virtual bool isStopRequested() { return false; }
};

/// Measures the time of each stage of a frame [ms]. The time of a stage that did not run is 0.
class StageClock : public StageObserver {
 public:
  void frameStarted() override {
    milliseconds_.fill(0.0);
    start_ = last_ = Clock::now();
  }
  void stageFinished(Stage stage) override {
    const Clock::time_point now = Clock::now();
    milliseconds_[static_cast<std::size_t>(stage)] += Milliseconds(now - last_).count();
    last_ = now;
  }

  double milliseconds(Stage stage) const { return milliseconds_[static_cast<std::size_t>(stage)]; }

  /// Returns the time from the start of the frame to the end of its last stage [ms].
  double totalMilliseconds() const { return Milliseconds(last_ - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::duration<double, std::milli>;

  std::array<double, kStageCount> milliseconds_{};
  Clock::time_point start_{};
  Clock::time_point last_{};
};

/// Width [px] of a Kinect's image whose pixels see the same angle as those of an image. The default method
/// resolves its parameters for it (see resolve()), so that sizes stay the same in the view; the published one
/// for the image's own width. At least 1, and at most 1.2 times the diagonal of the image: a lens with a long
/// focal length sees less, not smaller things.
/// @param camera         valid, see CameraIntrinsics::isValid()
/// @param width, height  [px] of the image
int kinectWidthOf(const CameraIntrinsics& camera, int width, int height);

/// Finds the planes of a depth image with line primitives, after Zhang, Chen and Liu (2016).
///
/// The same input and parameters give the same result, bit by bit, independent of earlier frames. After the
/// first frames of a size no memory is allocated. Not thread-safe: use one segmenter per thread.
class PlaneSegmenter {
 public:
  explicit PlaneSegmenter(const Parameters& parameters = {});
  ~PlaneSegmenter();
  PlaneSegmenter(PlaneSegmenter&&) noexcept;
  PlaneSegmenter& operator=(PlaneSegmenter&&) noexcept;

  /// Sets the parameters for the next frames, after sanitize().
  void setParameters(const Parameters& parameters);
  const Parameters& parameters() const;

  /// Segments one image. If the view is empty, the camera invalid or no depth valid, the result has no planes
  /// and all labels are 0. Never throws on bad data.
  /// @param observer  called at the end of each stage; may be null
  /// @return the result, valid until the next call; without planes if the observer requested a stop
  const Segmentation& segment(const DepthView& depth, const CameraIntrinsics& camera,
                              StageObserver* observer = nullptr);

  /// Returns the line segments of the last frame (Figure 4 of the paper). Computed by the first call after a
  /// frame.
  const std::vector<LineSegment>& lineSegments();

  /// Returns the plane candidates of the last frame, before extraction. Computed by the first call after a
  /// frame.
  const std::vector<PlaneCandidate>& candidates();

 private:
  struct Stages;
  std::unique_ptr<Stages> stages_;
};

}  // namespace line_plane_segmentation
