// SPDX-License-Identifier: BSD-3-Clause
// Segments the images of write_test_rooms with a Kinect's intrinsics and prints the results, for comparison
// between machines: one line for the labels of each image, then for each plane one with all digits, and a
// rounded one of the numbers that Eigen computes with fused multiply-adds where a processor always has them,
// as aarch64. Usage: segment_test_rooms <FILE
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"

namespace lps = line_plane_segmentation;

namespace {

std::uint64_t hashOf(const std::vector<std::uint16_t>& labels) {
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (const std::uint16_t label : labels) hash = (hash ^ label) * 1099511628211U;
  return hash;
}

void print(const lps::Segmentation& found) {
  std::printf("labels %016llx\n", static_cast<unsigned long long>(hashOf(found.labels)));
  for (const lps::SegmentedPlane& plane : found.planes) {
    std::printf("plane %d %u %a %a %a %a %a\n", plane.label, plane.inliers, plane.normal.x(),
                plane.normal.y(), plane.normal.z(), plane.d, plane.area);
    std::printf("rounded %.6e %.5e %.5e %.5e %.5e\n", plane.rms, plane.covariance(0, 0),
                plane.covariance(1, 1), plane.covariance(2, 2), plane.covariance(3, 3));
  }
}

}  // namespace

int main() {
  int images = 0, width = 0, height = 0;
  for (lps::PlaneSegmenter segmenter; std::cin >> width >> height && std::cin.get() == '\n'; ++images) {
    std::vector<std::uint16_t> depth(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::cin.read(reinterpret_cast<char*>(depth.data()),
                  static_cast<std::streamsize>(depth.size() * sizeof(std::uint16_t)));
    const double scale = width / 640.0;
    const lps::CameraIntrinsics camera{525.0 * scale, 525.0 * scale, (width - 1) / 2.0, (height - 1) / 2.0};
    print(segmenter.segment(lps::viewOf(depth.data(), width, height), camera));
  }
  return images > 0 ? 0 : 1;
}
