// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/plane_fit.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Fits a plane by PCA to the pixels of every label and fills in all that a SegmentedPlane tells but its outline.
///
/// Labels whose pixels span no plane are taken back to 0, and the labels above them move down.
class PlaneMeasurement {
 public:
  /// @param segmentation  its labels 1 to label_count are measured; everything else is filled in
  void measure(const DepthImage& depth, const ViewRays& rays, const CameraIntrinsics& camera, int label_count,
               Segmentation& segmentation);

 private:
  struct Sums {
    PointMoments moments;
    double cubed_depth = 0.0;
  };
  void addRun(const float* z, const float* x, int count, double y, Sums& sums) const;

  std::vector<Sums> sums_;
  std::vector<std::uint16_t> new_label_;
};

}  // namespace line_plane_segmentation
