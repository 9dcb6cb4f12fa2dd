// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_measurement.h"

#include <cmath>

namespace line_plane_segmentation {

void PlaneMeasurement::addRun(const float* z, const float* x, int count, double y, Sums& sums) const {
  double sum_z = 0.0, sum_zx = 0.0, sum_zz = 0.0, sum_zzx = 0.0, sum_zzxx = 0.0, sum_zzz = 0.0;
  for (int i = 0; i < count; ++i) {
    const double depth = z[i], ray = x[i];
    const double zz = depth * depth;
    sum_z += depth;
    sum_zx += depth * ray;
    sum_zz += zz;
    sum_zzx += zz * ray;
    sum_zzxx += zz * ray * ray;
    sum_zzz += zz * depth;
  }
  // A point is z (x, y, 1), and y is the same along the row.
  PointMoments& m = sums.moments;
  m.count += count;
  m.sum += Eigen::Vector3d(sum_zx, y * sum_z, sum_z);
  Eigen::Matrix3d outer;
  outer << sum_zzxx, y * sum_zzx, sum_zzx,  //
      y * sum_zzx, y * y * sum_zz, y * sum_zz,  //
      sum_zzx, y * sum_zz, sum_zz;
  m.outer += outer;
  sums.cubed_depth += sum_zzz;
}

void PlaneMeasurement::measure(const DepthImage& depth, const ViewRays& rays, const CameraIntrinsics& camera,
                               int label_count, Segmentation& segmentation) {
  sums_.assign(static_cast<std::size_t>(label_count) + 1, Sums{});
  for (int v = 0; v < depth.height; ++v) {
    const std::uint16_t* labels = segmentation.labels.data() + depth.index(0, v);
    const float* z = depth.row(v);
    for (int u = 0; u < depth.width;) {
      const std::uint16_t label = labels[u];
      const int first = u;
      while (u < depth.width && labels[u] == label) ++u;
      if (label == 0) continue;
      addRun(z + first, rays.x.data() + first, u - first, rays.y[static_cast<std::size_t>(v)], sums_[label]);
    }
  }

  segmentation.planes.clear();
  segmentation.assigned_pixels = 0;
  new_label_.assign(sums_.size(), 0);
  for (std::size_t label = 1; label < sums_.size(); ++label) {
    const PointMoments& moments = sums_[label].moments;
    PlaneFit fit;
    if (!fitPlane(moments, fit) || !(fit.d > 0.0)) continue;
    SegmentedPlane plane;
    plane.label = static_cast<std::uint16_t>(segmentation.planes.size() + 1);
    plane.normal = fit.normal;
    plane.d = fit.d;
    plane.centroid = fit.centroid;
    plane.rms = std::sqrt(fit.mean_square);
    plane.inliers = static_cast<std::uint32_t>(moments.count);
    // Three of the degrees of freedom went into the plane.
    plane.covariance = fit.covariance(moments, plane.rms * std::sqrt(moments.count / std::max(1.0, moments.count - 3.0)));
    // A pixel of depth z covers z² / (fx fy) facing the camera, and on the plane, seen under the angle whose cosine
    // is d / (z |ray|) there, z³ / (d fx fy).
    plane.area = sums_[label].cubed_depth / (fit.d * camera.fx * camera.fy);
    segmentation.planes.push_back(plane);
    segmentation.assigned_pixels += plane.inliers;
    new_label_[label] = plane.label;
  }
  if (segmentation.planes.size() == static_cast<std::size_t>(label_count)) return;
  for (std::uint16_t& label : segmentation.labels) label = new_label_[label];
}

}  // namespace line_plane_segmentation
