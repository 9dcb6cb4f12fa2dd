// SPDX-License-Identifier: BSD-3-Clause
#include "refine/plane_measurement.h"

#include <algorithm>
#include <cmath>

#include "kernels/row_kernels.h"

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

double total(const PixelSums::Lanes& lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

PointMoments momentsOf(const PixelSums& sums) {
  PointMoments moments;
  moments.count = sums.pixels;
  moments.sum << total(sums.zx), total(sums.zy), total(sums.z);
  const double zzx = total(sums.zzx), zzy = total(sums.zzy), zzxy = total(sums.zzxy);
  moments.outer << total(sums.zzxx), zzxy, zzx,  //
      zzxy, total(sums.zzyy), zzy,               //
      zzx, zzy, total(sums.zz);
  return moments;
}

}  // namespace

void PlaneMeasurement::sumLabels(const DepthImage& depth, const ViewRays& rays, int label_count,
                                 const LabelRuns& image, bool has_invalid) {
  sums_.assign(static_cast<std::size_t>(label_count) + 1, PixelSums{});
  filled_.assign(sums_.size(), 0.0);
  ray_x_.assign(rays.x.begin(), rays.x.end());
  for (const LabelRun& run : image.runs) {
    if (run.label == 0) continue;
    const float* z = depth.row(run.row) + run.first;
    PixelSums& sums = sums_[run.label];
    addRun(z, ray_x_.data() + run.first, static_cast<double>(rays.y[run.row]), run.pixels(), sums);
    if (!has_invalid) continue;
    const double invalid = static_cast<double>(std::count(z, z + run.pixels(), 0.0F));
    sums.pixels -= invalid;
    filled_[run.label] += invalid;
  }
}

void PlaneMeasurement::measure(const DepthImage& depth, const ViewRays& rays, const CameraIntrinsics& camera,
                               int label_count, double min_area, LabelRuns& image, Segmentation& segmentation,
                               const std::vector<std::optional<PlaneEstimate>>& estimates, bool has_invalid) {
  sumLabels(depth, rays, label_count, image, has_invalid);
  segmentation.planes.clear();
  segmentation.assigned_pixels = 0;
  new_label_.assign(sums_.size(), 0);
  for (std::size_t label = 1; label < sums_.size(); ++label) {
    const PointMoments moments = momentsOf(sums_[label]);
    PlaneFit fit;
    if (!fitPlane(moments, fit)) continue;
    const PlaneEstimate estimate = estimates.empty()
                                       ? fittedPlane(fit, moments)
                                       : estimates[label - 1].value_or(estimateFromPixels(fit, moments));
    const double edge_on = kEdgeOn * fit.centroid.norm();
    // Where one looks along a plane of patches, the mean of its pixels may lie on the camera's other side.
    if (!(estimate.d > edge_on && -estimate.normal.dot(fit.centroid) > edge_on)) continue;
    // A pixel of depth z covers z² / (fx fy) facing the camera, and on the plane, seen under the angle whose
    // cosine is d / (z |ray|) there, z³ / (d fx fy). Filled pixels are as large as measured ones on average.
    const double area = total(sums_[label].zzz) / (estimate.d * camera.fx * camera.fy) *
                        (1.0 + filled_[label] / moments.count);
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
  for (LabelRun& run : image.runs) run.label = new_label_[run.label];
}

}  // namespace line_plane_segmentation
