// SPDX-License-Identifier: BSD-3-Clause
#include "lines/scanline.h"

#include <cmath>

namespace line_plane_segmentation {

int scanlineCount(int pixels, int spacing) { return pixels > 0 ? (pixels - 1) / spacing : 0; }

void projectScanline(const DepthImage& depth, const CameraIntrinsics& camera, ScanDirection direction,
                     int index, Scanline& scanline) {
  const bool is_row = direction == ScanDirection::kRow;
  const int count = is_row ? depth.width : depth.height;
  const double along_focal = is_row ? camera.fx : camera.fy;
  const double along_centre = is_row ? camera.cx : camera.cy;
  const double orthogonal_ray = is_row ? (index - camera.cy) / camera.fy : (index - camera.cx) / camera.fx;
  const double k = std::sqrt(orthogonal_ray * orthogonal_ray + 1.0);  // Eq. 3
  const float* z = depth.z.data() + (is_row ? depth.index(0, index) : depth.index(index, 0));
  const std::size_t stride = is_row ? 1 : static_cast<std::size_t>(depth.width);

  scanline.direction = direction;
  scanline.index = index;
  scanline.points.clear();
  for (int i = 0; i < count; ++i, z += stride) {
    if (*z == 0.0F) continue;
    const double pz = *z;
    scanline.points.push_back({i, k * pz, (i - along_centre) / along_focal * pz, pz});
  }
}

}  // namespace line_plane_segmentation
