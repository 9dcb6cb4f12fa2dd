// SPDX-License-Identifier: BSD-3-Clause
#include "pcl_baselines.h"

#include <cmath>
#include <limits>

#include "pcl_engines.h"

namespace line_plane_segmentation {
namespace {

constexpr int kVgaPixels = 640 * 480;
constexpr int kQvgaPixels = 320 * 240;

}  // namespace

// This source is compiled twice.
#ifdef COMPILING_WITH_AVX2
std::unique_ptr<Engine> makePclEngineWithAvx2(PclMethod method) {
#else
std::unique_ptr<Engine> makePclEngine(PclMethod method) {
#endif
  switch (method) {
    case PclMethod::kOmps:
      return makeOmps(false);
    case PclMethod::kOmpsRefined:
      return makeOmps(true);
    case PclMethod::kRansac:
      return makeRansac();
    case PclMethod::kRegionGrowing:
#ifndef COMPILING_WITH_AVX2
      return makeRegionGrowing();
#endif
      break;
  }
  return nullptr;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr organisedCloud(const BenchmarkFrame& frame) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->width = static_cast<std::uint32_t>(frame.width);
  cloud->height = static_cast<std::uint32_t>(frame.height);
  cloud->is_dense = false;
  cloud->points.reserve(frame.depth.size());
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const int u = static_cast<int>(i) % frame.width;
    const int v = static_cast<int>(i) / frame.width;
    const float z = frame.depth[i] == 0 ? kNone : static_cast<float>(frame.depth[i]) * frame.depth_unit;
    cloud->points.emplace_back(static_cast<float>((u - frame.camera.cx) / frame.camera.fx) * z,
                               static_cast<float>((v - frame.camera.cy) / frame.camera.fy) * z, z);
  }
  return cloud;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr validPoints(const BenchmarkFrame& frame) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  const pcl::PointCloud<pcl::PointXYZ>::Ptr all = organisedCloud(frame);
  for (const pcl::PointXYZ& point : all->points) {
    if (std::isfinite(point.z)) cloud->push_back(point);
  }
  return cloud;
}

std::vector<std::uint16_t> labelsOfOrganised(const BenchmarkFrame& frame,
                                             const std::vector<pcl::PointIndices>& planes) {
  std::vector<std::uint16_t> labels(frame.depth.size(), 0);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (const auto index : planes[k].indices) labels[index] = static_cast<std::uint16_t>(k + 1);
  }
  return labels;
}

std::vector<std::uint16_t> labelsOfValid(const BenchmarkFrame& frame,
                                         const std::vector<pcl::PointIndices>& planes) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (frame.depth[i] != 0) pixels.push_back(i);
  }
  std::vector<std::uint16_t> labels(frame.depth.size(), 0);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (const auto index : planes[k].indices) {
      labels[pixels[index]] = static_cast<std::uint16_t>(k + 1);
    }
  }
  return labels;
}

int pixelsAt(const BenchmarkFrame& frame, int at_vga, int at_qvga) {
  const double pixels = static_cast<double>(frame.width) * frame.height;
  if (pixels <= kQvgaPixels) return static_cast<int>(std::lround(at_qvga * pixels / kQvgaPixels));
  if (pixels >= kVgaPixels) return static_cast<int>(std::lround(at_vga * pixels / kVgaPixels));
  const double fraction = (pixels - kQvgaPixels) / (kVgaPixels - kQvgaPixels);
  return static_cast<int>(std::lround(at_qvga + fraction * (at_vga - at_qvga)));
}

}  // namespace line_plane_segmentation
