// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "depth/depth_image.h"
#include "kernels/pixel_sums.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"
#include "refine/label_runs.h"
#include "refine/plane_estimate.h"

namespace line_plane_segmentation {

/// Measures the planes of a label image from the pixels of every label: fills in all that a SegmentedPlane
/// tells but its outline.
///
/// Labels whose pixels span no plane, or less than the smallest area, are taken back to 0, and the labels
/// above them move down.
class PlaneMeasurement {
 public:
  /// @param label_count  labels 1 to label_count are measured
  /// @param min_area     [m²] planes with a smaller area go
  /// @param image        its labels are 0 to label_count; relabelled where a label goes
  /// @param result       receives the planes, and the number of its assigned pixels
  /// @param estimates    the coefficients of label k are estimates[k - 1], or where there is none those of
  ///                     estimateFromPixels(); if the vector is empty, each is fitted by PCA to all of its
  ///                     pixels, as the paper has it
  /// @param has_invalid  whether labels also cover pixels without depth, which count for the area only
  void measure(const DepthImage& depth, const ViewRays& rays, const CameraIntrinsics& camera, int label_count,
               double min_area, LabelRuns& image, Segmentation& result,
               const std::vector<std::optional<PlaneEstimate>>& estimates = {}, bool has_invalid = false);

 private:
  void sumLabels(const DepthImage& depth, const ViewRays& rays, int label_count, const LabelRuns& image,
                 bool has_invalid);

  std::vector<PixelSums> sums_;  // of each label
  std::vector<double> filled_;   // pixels without depth of each label
  std::vector<double> ray_x_;    // of each column
  std::vector<std::uint16_t> new_label_;
};

}  // namespace line_plane_segmentation
