// SPDX-License-Identifier: BSD-3-Clause
#include "depth/depth_image.h"

namespace line_plane_segmentation {
namespace {

void computeAxis(double focal_length, double centre, int count, std::vector<float>& axis) {
  axis.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    axis[i] = static_cast<float>((i - centre) / focal_length);
  }
}

}  // namespace

std::uint32_t loadDepth(const DepthView& view, const DepthRange& range, DepthImage& image) {
  image.width = view.width;
  image.height = view.height;
  image.z.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  std::uint32_t depths = 0;
  for (int v = 0; v < view.height; ++v)
    depths += static_cast<std::uint32_t>(loadRow(view, v, range, image.row(v)));
  return depths;
}

void ViewRays::compute(const CameraIntrinsics& camera, int width, int height) {
  computeAxis(camera.fx, camera.cx, width, x);
  computeAxis(camera.fy, camera.cy, height, y);
}

}  // namespace line_plane_segmentation
