// SPDX-License-Identifier: BSD-3-Clause
#include "refine/plane_estimate.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

// Pixels of a narrow surface that count as independent.
constexpr double kIndependentPixels = 48.0;

// A candidate's pixels share their errors, and so do neighbouring candidates: so many count as one. In
// simulated frames 94 % of the normalised errors are then within their 95 % bound.
constexpr double kSharedCandidates = 2.6;

// The variance of few candidates is uncertain: it counts beside that of the pixels, which has the weight of
// so many candidates.
constexpr double kPriorCandidates = 4.0;

// The weighted sum of squared errors about a plane.
double squaredErrorAbout(const InverseDepthPlane& plane, const RegressionMoments& m) {
  const double a = plane.a, b = plane.b, c = plane.c;
  const double linear = a * m.x_rho + b * m.y_rho + c * m.rho;
  const double square =
      a * a * m.xx + b * b * m.yy + c * c * m.weight + 2.0 * (a * b * m.xy + a * c * m.x + b * c * m.y);
  return std::max(0.0, m.rho_rho - 2.0 * linear + square);
}

// The variance of the candidates' mean points about their plane [tolerance²].
double varianceOf(const PlaneCluster& cluster) {
  const double candidates = cluster.candidates, pixels = cluster.moments.pixels;
  const double of_pixels = cluster.squared_error / std::max(1.0, pixels - 3.0);
  const double expected = kSharedErrors / kSharedCandidates * of_pixels * candidates / pixels;
  return (kPriorCandidates * expected + squaredErrorAbout(cluster.plane, cluster.means)) /
         (kPriorCandidates + std::max(0.0, candidates - 3.0));
}

// The plane with the coefficients (a, b, c) = -normal / d of its inverse depth, and their covariance.
PlaneEstimate describe(const Eigen::Vector3d& coefficients, const Eigen::Matrix3d& covariance) {
  PlaneEstimate estimate;
  estimate.d = 1.0 / coefficients.norm();
  estimate.normal = -estimate.d * coefficients;
  Eigen::Matrix<double, 4, 3> jacobian;  // of normal and d by the coefficients
  jacobian.topRows<3>() =
      -estimate.d * (Eigen::Matrix3d::Identity() - estimate.normal * estimate.normal.transpose());
  jacobian.row(3) = estimate.d * estimate.d * estimate.normal.transpose();
  estimate.covariance = jacobian * covariance * jacobian.transpose();
  return estimate;
}

}  // namespace

PlaneEstimate estimatePlane(const PlaneCluster& cluster) {
  const RegressionMoments& m = cluster.means;
  const Eigen::Vector3d coefficients(cluster.plane.a, cluster.plane.b, cluster.plane.c);
  Eigen::Matrix3d information;
  information << m.xx, m.xy, m.x, m.xy, m.yy, m.y, m.x, m.y, m.weight;
  const Eigen::Matrix3d covariance = kSharedCandidates * varianceOf(cluster) * information.inverse();

  return describe(coefficients, covariance);
}

PlaneEstimate estimateFromPixels(const PlaneFit& fit, const PointMoments& moments) {
  // A point p of depth z = 1 / rho lies on the ray p rho. So 1 - (a, b, c) . p is the error of the inverse
  // depth, relative to it: to minimise its squares is a regression along the rays, as the noise is.
  const Eigen::LDLT<Eigen::Matrix3d> solver(moments.outer);
  const Eigen::Vector3d coefficients = solver.solve(moments.sum);
  const double shared = std::max(1.0, moments.count / kIndependentPixels);
  const double squared_error = moments.count - coefficients.dot(moments.sum);
  const bool is_solved = solver.info() == Eigen::Success && coefficients.allFinite() &&
                         squared_error >= 0.0 && coefficients.squaredNorm() > 0.0;
  if (!is_solved) return {fit.normal, fit.d, fit.covariance(moments, std::sqrt(shared * fit.mean_square))};
  const double variance = shared * squared_error / std::max(1.0, moments.count - 3.0);
  return describe(coefficients, variance * solver.solve(Eigen::Matrix3d::Identity()));
}

}  // namespace line_plane_segmentation
