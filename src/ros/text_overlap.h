// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// Selects texts that do not overlap in the camera's image, in the order in which they are added. The texts
/// face the camera.
class TextOverlapFilter {
 public:
  explicit TextOverlapFilter(const CameraIntrinsics& camera) : camera_(camera) {}

  /// Adds a text unless it overlaps an earlier one.
  /// @param center  centre of the text [m], in the optical frame
  /// @param height  height of a capital letter [m]
  /// @return true if the text was added; always true behind the camera
  bool addIfFree(const Eigen::Vector3d& center, double height, const std::string& text);

 private:
  struct Box {  // [px]
    double left, right, top, bottom;
  };

  CameraIntrinsics camera_;
  std::vector<Box> boxes_;
};

}  // namespace line_plane_segmentation
