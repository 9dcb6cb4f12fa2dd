// SPDX-License-Identifier: BSD-3-Clause
#include "refine/plane_estimate.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr double kIndependentPixels = 8.0;

}  // namespace

PlaneEstimate estimatePlane(const PlaneCluster& cluster) {
  const RegressionMoments& m = cluster.moments;
  const Eigen::Vector3d coefficients(cluster.plane.a, cluster.plane.b, cluster.plane.c);
  PlaneEstimate estimate;
  estimate.d = 1.0 / coefficients.norm();
  estimate.normal = -estimate.d * coefficients;

  Eigen::Matrix3d information;
  information << m.xx, m.xy, m.x, m.xy, m.yy, m.y, m.x, m.y, m.weight;
  const double variance = cluster.squared_error / std::max(1.0, m.pixels - 3.0);
  const Eigen::Matrix3d covariance = kSharedErrors * variance * information.inverse();

  // (a, b, c) = -normal / d: the derivatives of normal and d by it.
  Eigen::Matrix<double, 4, 3> jacobian;
  jacobian.topRows<3>() =
      -estimate.d * (Eigen::Matrix3d::Identity() - estimate.normal * estimate.normal.transpose());
  jacobian.row(3) = estimate.d * estimate.d * estimate.normal.transpose();
  estimate.covariance = jacobian * covariance * jacobian.transpose();
  return estimate;
}

PlaneEstimate estimateFromPixels(const PlaneFit& fit, const PointMoments& moments) {
  const double shared = std::max(1.0, moments.count / kIndependentPixels);
  return {fit.normal, fit.d, fit.covariance(moments, std::sqrt(shared * fit.mean_square))};
}

}  // namespace line_plane_segmentation
