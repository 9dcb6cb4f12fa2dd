// SPDX-License-Identifier: BSD-3-Clause
// Two walls of a made-up depth image, found.
#include <line_plane_segmentation/plane_segmenter.h>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

int main() {
  const int width = 640, height = 480;
  const line_plane_segmentation::CameraIntrinsics camera{525.0, 525.0, 319.5, 239.5};

  // A corner two metres ahead: both walls come nearer towards the sides of the picture.
  std::vector<std::uint16_t> millimetres;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const double x = (u - camera.cx) / camera.fx;
      millimetres.push_back(static_cast<std::uint16_t>(2000.0 / (1.0 + std::abs(x))));
    }
  }

  line_plane_segmentation::PlaneSegmenter segmenter;
  const auto view = line_plane_segmentation::viewOf(millimetres.data(), width, height);
  const line_plane_segmentation::Segmentation& found = segmenter.segment(view, camera);
  for (const line_plane_segmentation::SegmentedPlane& plane : found.planes) {
    std::cout << "plane " << plane.label << ": " << plane.inliers << " pixels, " << plane.d
              << " m from the camera, normal " << plane.normal.transpose() << "\n";
  }
  return found.planes.size() == 2 ? 0 : 1;
}
