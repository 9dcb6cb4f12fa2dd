// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measurement.h"

namespace line_plane_segmentation {

/// Time of several cameras on one core.
struct CameraLoad {
  int cameras = 0;
  Statistics round;  ///< [ms] one frame of each
};

/// Measures how times grow with the image: one room from 160x120 to 1920x1080.
std::vector<Measurement> measureSizes(const MeasurementOptions& options);

/// Measures how times grow with the number of planes: 0 to 50 at VGA.
std::vector<Measurement> measurePlanes(const MeasurementOptions& options);

/// Measures how times grow with the number of cameras: 1 to 8 at VGA, each with its own segmenter and room,
/// processed in turn.
std::vector<CameraLoad> measureCameras(const MeasurementOptions& options);

}  // namespace line_plane_segmentation
