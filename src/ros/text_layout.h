// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// Keeps texts that face the camera from covering each other in its image. A text that is reserved first
/// stays.
class TextLayout {
 public:
  explicit TextLayout(const CameraIntrinsics& camera) : camera_(camera) {}

  /// Reserves the place of a text unless it covers a part of one that is reserved.
  /// @param center  of the text [m], in the optical frame
  /// @param height  of a capital letter [m]
  /// @return whether the place was free; always true behind the camera
  bool reserve(const Eigen::Vector3d& center, double height, const std::string& text);

 private:
  struct Box {  // [px]
    double left, right, top, bottom;
  };

  CameraIntrinsics camera_;
  std::vector<Box> boxes_;
};

}  // namespace line_plane_segmentation
