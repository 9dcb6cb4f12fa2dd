// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/segmentation.h"
#include "refine/label_runs.h"
#include "refine/plane_estimate.h"

namespace line_plane_segmentation {

/// What the stages of a frame work on.
struct Frame {
  DepthImage depth;
  ViewRays rays;
  CameraIntrinsics camera;
  int kinect_width = 0;   ///< [px] of a Kinect's image whose pixels see the same angle: lengths follow it
  Parameters parameters;  ///< resolved for that width, by the paper's method for the image's own
};

/// The result of the stage "extraction".
struct LabeledPlanes {
  LabelRuns runs;  ///< labels 1 to label_count, 0 for no plane
  int label_count = 0;
  /// Per label, the plane as the method estimated it. If there is none, the plane is fitted to all pixels of
  /// the label with errors that neighbouring pixels share. If the vector is empty, with independent errors.
  std::vector<std::optional<PlaneEstimate>> estimates;
};

/// The stages in which the paper's method and the default one differ, in their order. What follows
/// (measurement, outlines) is shared.
class SegmentationMethod {
 public:
  virtual ~SegmentationMethod() = default;

  /// Scanlines and line segments. May adapt the frame's noise model to its depth.
  virtual void extractLines(Frame& frame) = 0;

  /// Plane candidates, from the line segments.
  virtual void detectCandidates(const Frame& frame) = 0;

  /// Planes, from the candidates.
  /// @param observer  may end the stage early
  virtual void extractPlanes(const Frame& frame, StageObserver& observer, LabeledPlanes& planes) = 0;

  /// Cleans the labels; part of the stage "refinement".
  virtual void refine(const Frame& frame, LabeledPlanes& planes) = 0;

  /// The segments and candidates of the last frame.
  virtual void describe(const Frame& frame, std::vector<LineSegment>& segments,
                        std::vector<PlaneCandidate>& candidates) const = 0;
};

}  // namespace line_plane_segmentation
