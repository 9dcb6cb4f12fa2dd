// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_measurement.h"

#include <algorithm>
#include <cmath>

#include "row_kernels.h"

namespace line_plane_segmentation {
namespace {

// Cosine of the angle between the normal and the line of sight. Pixels of one row or column alone lie in a
// plane through the camera, whose distance is nothing but rounding; nobody sees such a plane.
constexpr double kEdgeOn = 1e-6;

// The fit as it is, each pixel's error being its own.
PlaneEstimate fittedPlane(const PlaneFit& fit, const PointMoments& moments) {
  // Three of the degrees of freedom went into the plane.
  const double sigma = std::sqrt(fit.mean_square * moments.count / std::max(1.0, moments.count - 3.0));
  return {fit.normal, fit.d, fit.covariance(moments, sigma)};
}

}  // namespace

void PlaneMeasurement::sumLabels(const DepthImage& depth, const ViewRays& rays, int label_count,
                                 const LabelRuns& image) {
  sums_.assign(static_cast<std::size_t>(label_count) + 1, Sums{});
  for (const LabelRun& run : image.runs) {
    if (run.label == 0 || run.label == kNoDepthLabel) continue;
    const RunSums s = sumRun(depth.row(run.row) + run.first, rays.x.data() + run.first, run.pixels());
    const double y = rays.y[static_cast<std::size_t>(run.row)];
    // A point is z (x, y, 1), and y is the same along the row.
    Sums& sums = sums_[run.label];
    sums.moments.count += run.pixels();
    sums.moments.sum += Eigen::Vector3d(s.zx, y * s.z, s.z);
    Eigen::Matrix3d outer;
    outer << s.zzxx, y * s.zzx, s.zzx,      //
        y * s.zzx, y * y * s.zz, y * s.zz,  //
        s.zzx, y * s.zz, s.zz;
    sums.moments.outer += outer;
    sums.cubed_depth += s.zzz;
  }
}

void PlaneMeasurement::measure(const DepthImage& depth, const ViewRays& rays, const CameraIntrinsics& camera,
                               int label_count, double min_area, LabelRuns& image, Segmentation& segmentation,
                               const std::vector<std::optional<PlaneEstimate>>& estimates) {
  sumLabels(depth, rays, label_count, image);
  segmentation.planes.clear();
  segmentation.assigned_pixels = 0;
  new_label_.assign(sums_.size(), 0);
  for (std::size_t label = 1; label < sums_.size(); ++label) {
    const PointMoments& moments = sums_[label].moments;
    PlaneFit fit;
    if (!fitPlane(moments, fit)) continue;
    const PlaneEstimate estimate = estimates.empty()
                                       ? fittedPlane(fit, moments)
                                       : estimates[label - 1].value_or(estimateFromPixels(fit, moments));
    const double edge_on = kEdgeOn * fit.centroid.norm();
    // Where one looks along a plane of patches, the mean of its pixels may lie on the camera's other side.
    if (!(estimate.d > edge_on && -estimate.normal.dot(fit.centroid) > edge_on)) continue;
    // A pixel of depth z covers z² / (fx fy) facing the camera, and on the plane, seen under the angle whose
    // cosine is d / (z |ray|) there, z³ / (d fx fy).
    const double area = sums_[label].cubed_depth / (estimate.d * camera.fx * camera.fy);
    if (!(area >= min_area)) continue;
    SegmentedPlane plane;
    plane.label = static_cast<std::uint16_t>(segmentation.planes.size() + 1);
    plane.normal = estimate.normal;
    plane.d = estimate.d;
    plane.covariance = estimate.covariance;
    plane.centroid = fit.centroid;
    plane.rms = std::sqrt(moments.meanSquareDistance(estimate.normal, estimate.d));
    plane.inliers = static_cast<std::uint32_t>(moments.count);
    plane.area = area;
    segmentation.planes.push_back(plane);
    segmentation.assigned_pixels += plane.inliers;
    new_label_[label] = plane.label;
  }
  if (segmentation.planes.size() == static_cast<std::size_t>(label_count)) return;
  for (LabelRun& run : image.runs) {
    if (run.label != kNoDepthLabel) run.label = new_label_[run.label];
  }
}

}  // namespace line_plane_segmentation
