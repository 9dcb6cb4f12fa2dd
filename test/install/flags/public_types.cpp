// SPDX-License-Identifier: BSD-3-Clause
// Programs that are compiled with other flags than the library must get the same from it. With --layout this
// one prints its public types' sizes and alignments as static assertions, which a build of it with other
// flags takes as EXPECTED_LAYOUT: so layouts are compared of programs that this machine cannot run, too.
// Without, it prints the planes of a corner, each number to the last bit.
#include <line_plane_segmentation/orientation.h>
#include <line_plane_segmentation/plane_segmenter.h>
#include <line_plane_segmentation/plane_tracker.h>
#include <line_plane_segmentation/segmentation.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#ifdef EXPECTED_LAYOUT
#include EXPECTED_LAYOUT
#endif

namespace lps = line_plane_segmentation;

namespace {

template <typename Type>
void printLayout(const char* name) {
  std::printf(
      "static_assert(sizeof(line_plane_segmentation::%s) == %zu && "
      "alignof(line_plane_segmentation::%s) == %zu);\n",
      name, sizeof(Type), name, alignof(Type));
}

template <typename Matrix>
void print(const char* name, const Matrix& matrix) {
  std::printf("  %s", name);
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) {
      std::printf(" %a", static_cast<double>(matrix(row, column)));
    }
  }
  std::printf("\n");
}

void print(const lps::SegmentedPlane& plane) {
  std::printf("plane %d: %u pixels, d %a, rms %a, area %a\n", plane.label, plane.inliers, plane.d, plane.rms,
              plane.area);
  print("normal", plane.normal);
  print("centroid", plane.centroid);
  print("covariance", plane.covariance);
}

void printLayouts() {
  printLayout<lps::CameraIntrinsics>("CameraIntrinsics");
  printLayout<lps::DepthView>("DepthView");
  printLayout<lps::Parameters>("Parameters");
  printLayout<lps::PlaneSegmenter>("PlaneSegmenter");
  printLayout<lps::Segmentation>("Segmentation");
  printLayout<lps::SegmentedPlane>("SegmentedPlane");
  printLayout<lps::Ring>("Ring");
  printLayout<lps::LineSegment>("LineSegment");
  printLayout<lps::PlaneCandidate>("PlaneCandidate");
  printLayout<lps::PlaneTracker>("PlaneTracker");
  printLayout<lps::TrackingParameters>("TrackingParameters");
  printLayout<lps::RigidTransform>("RigidTransform");
}

std::vector<std::uint16_t> cornerInMillimetres(int width, int height, const lps::CameraIntrinsics& camera) {
  std::vector<std::uint16_t> depth;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const double x = (u - camera.cx) / camera.fx, below = (v - camera.cy) / camera.fy;
      const double wall = 2.0 / (1.0 + std::abs(x));
      depth.push_back(static_cast<std::uint16_t>(1000.0 * (below * wall > 0.6 ? 0.6 / below : wall)));
    }
  }
  return depth;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--layout") == 0) {
    printLayouts();
    return 0;
  }
  const int width = 640, height = 480;
  const lps::CameraIntrinsics camera{525.0, 525.0, 319.5, 239.5};
  const std::vector<std::uint16_t> depth = cornerInMillimetres(width, height, camera);

  lps::PlaneSegmenter segmenter;
  const lps::Segmentation& found = segmenter.segment(lps::viewOf(depth.data(), width, height), camera);
  std::uint64_t hash = 14695981039346656037U;
  for (const std::uint16_t label : found.labels) hash = (hash ^ label) * 1099511628211U;
  std::printf("labels %016llx\n", static_cast<unsigned long long>(hash));
  for (const Eigen::Vector3f& vertex : found.vertices) print("vertex", vertex);
  for (const lps::LineSegment& line : segmenter.lineSegments()) print("line", line.covariance);
  for (const lps::PlaneCandidate& candidate : segmenter.candidates()) print("candidate", candidate.normal);

  // Eigen's own type: as callers have it.
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitY()));
  motion.pretranslate(Eigen::Vector3d(0.125, 0.25, 0.5));
  for (const lps::SegmentedPlane& plane : found.planes) {
    print(plane);
    print(lps::transformed(plane, motion));
    const lps::Orientation orientation = lps::orientationOf(plane.normal, -Eigen::Vector3d::UnitY(), 0.17);
    std::printf("  %s\n", lps::nameOf(orientation));
  }
  lps::PlaneTracker tracker;
  tracker.track(found, camera, 0.0);
  for (const std::uint32_t id : tracker.track(found, camera, 0.1, &motion)) std::printf("id %u\n", id);
  return found.planes.size() == 3 ? 0 : 1;
}
