// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// One point of a 2-D scan.
struct ScanPoint {
  int pixel = 0;   ///< [px] position along the scanline
  double x = 0.0;  ///< [m] Sx, distance from the camera's axis along the scanline
  double y = 0.0;  ///< [m] Sy, along the scanline
  double z = 0.0;  ///< [m] depth
};

/// A row or column of the depth image as a 2-D scan: the curve along which its plane of sight cuts
/// the scene, holes left out. The scan of a plane is a line.
struct Scanline {
  ScanDirection direction = ScanDirection::kRow;
  int index = 0;                  ///< [px] which row or column
  std::vector<ScanPoint> points;  ///< in the order of their pixels
};

/// How many scanlines an image has along one side: one at every `spacing`-th pixel but the first.
int scanlineCount(int pixels, int spacing);

/// Projects a row or column, Eq. 1-3. For a row, Sy = Px and Sx = k Pz with k = sqrt(((v - cy) / fy)^2 + 1);
/// for a column x and y change places.
void projectScanline(const DepthImage& depth, const CameraIntrinsics& camera, ScanDirection direction,
                     int index, Scanline& scanline);

}  // namespace line_plane_segmentation
