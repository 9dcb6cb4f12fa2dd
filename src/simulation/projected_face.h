// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "image_row.h"
#include "renderer.h"

namespace line_plane_segmentation::simulation {

/// Projection of a face.
class ProjectedFace {
 public:
  /// @param vertices  [m] in the optical frame, at least 3
  /// @param plane     of the face, d positive
  /// @param height    [px] of the image
  ProjectedFace(const std::vector<Eigen::Vector3d>& vertices, const VisiblePlane& plane,
                const CameraIntrinsics& k, int height);

  /// Renders the face into row `v` where it is nearer than the surfaces there.
  void draw(int v, ImageRow& row) const;

 private:
  void limitRows(const std::vector<Eigen::Vector3d>& vertices, const CameraIntrinsics& k);

  std::int64_t label_;
  LinearInPixels inverse_depth_;
  std::vector<LinearInPixels> sides_;  // not negative on the inner side
  int first_row_ = 0;
  int last_row_;
};

}  // namespace line_plane_segmentation::simulation
