// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <topic_tools/shape_shifter.h>

#include <string>
#include <vector>

#include "test_camera.h"

namespace line_plane_segmentation {

/// Subscriber of a topic of any type.
using Anything = Inbox<topic_tools::ShapeShifter>;

/// Names of all topics that a segmenter publishes.
inline const std::vector<std::string>& outputs() {
  static const std::vector<std::string> kOutputs = {
      "planes",  "labels",        "cloud", "overlay", "markers", "scanlines", "cloud_without_planes",
      "objects", "tracked_planes"};
  return kOutputs;
}

}  // namespace line_plane_segmentation
