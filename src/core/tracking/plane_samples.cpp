// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/plane_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace line_plane_segmentation {

void samplePlanes(const Segmentation& segmentation, const CameraIntrinsics& camera,
                  std::vector<PlaneSample>& samples, std::vector<int>& counts) {
  constexpr int kGridColumns = 48;
  constexpr double kEdgeOn = -1e-3;  // there a pixel's ray meets the plane anywhere
  samples.clear();
  counts.assign(segmentation.planes.size(), 0);
  const int step = std::max(1, segmentation.width / kGridColumns);
  for (int v = step / 2; v < segmentation.height; v += step) {
    const std::uint16_t* labels = segmentation.labels.data() +
                                  static_cast<std::size_t>(v) * static_cast<std::size_t>(segmentation.width);
    for (int u = step / 2; u < segmentation.width; u += step) {
      if (labels[u] == 0) continue;
      const int k = labels[u] - 1;
      const SegmentedPlane& plane = segmentation.planes[k];
      const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const double along = plane.normal.dot(ray);
      if (along > kEdgeOn) continue;
      samples.push_back({(-plane.d / along * ray).cast<float>(), k});
      ++counts[k];
    }
  }
}

void VoteTable::add(std::size_t owner, int plane, float distance) {
  SampleVotes* const pairs = votes_.data() + first_[owner];
  int i = 0;
  while (i < pairs_[owner] && pairs[i].plane != plane) ++i;
  if (i == pairs_[owner]) {
    pairs[i] = {plane, 0, 0.0F};
    ++pairs_[owner];
  }
  ++pairs[i].samples;
  pairs[i].distance += distance;
}

void VoteTable::count(const std::vector<PlaneSample>& samples, std::size_t owner_count,
                      const Segmentation& segmentation, const CameraIntrinsics& camera) {
  constexpr float kNearest = 0.01F;  // [m]
  in_view_.assign(owner_count, 0);
  pairs_.assign(owner_count, 0);
  votes_.resize(samples.size());
  first_.assign(owner_count + 1, 0);
  for (const PlaneSample& sample : samples) ++first_[sample.owner + 1];
  for (std::size_t owner = 0; owner < owner_count; ++owner) first_[owner + 1] += first_[owner];

  const auto fx = static_cast<float>(camera.fx), fy = static_cast<float>(camera.fy);
  // Half a pixel more: then truncation rounds.
  const auto cx = static_cast<float>(camera.cx + 0.5), cy = static_cast<float>(camera.cy + 0.5);
  const auto width = static_cast<float>(segmentation.width), height = static_cast<float>(segmentation.height);
  for (const PlaneSample& sample : samples) {
    const Eigen::Vector3f& p = sample.point;
    if (p.z() < kNearest) continue;
    const float u = fx * p.x() / p.z() + cx, v = fy * p.y() / p.z() + cy;
    if (!(u >= 0.0F && u < width && v >= 0.0F && v < height)) continue;
    const auto owner = static_cast<std::size_t>(sample.owner);
    ++in_view_[owner];
    const std::size_t pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(segmentation.width) +
                              static_cast<std::size_t>(u);
    const int label = segmentation.labels[pixel];
    if (label == 0) continue;
    const SegmentedPlane& plane = segmentation.planes[label - 1];
    const float distance = plane.normal.cast<float>().dot(p) + static_cast<float>(plane.d);
    add(owner, label - 1, std::abs(distance) / p.z());
  }
}

}  // namespace line_plane_segmentation
