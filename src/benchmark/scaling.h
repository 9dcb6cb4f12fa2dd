// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measurement.h"

namespace line_plane_segmentation {

/// What several cameras on one core cost.
struct CameraLoad {
  int cameras = 0;
  Statistics round;  ///< [ms] one frame of each
};

/// How times grow with the image: one room from 160x120 to 1920x1080.
std::vector<Measurement> measureSizes(const MeasurementOptions& options);

/// How times grow with what is seen: 0 to 50 planes at VGA.
std::vector<Measurement> measurePlanes(const MeasurementOptions& options);

/// How times grow with the cameras: 1 to 8 at VGA, each with a segmenter and a room of its own, served in
/// turn.
std::vector<CameraLoad> measureCameras(const MeasurementOptions& options);

}  // namespace line_plane_segmentation
