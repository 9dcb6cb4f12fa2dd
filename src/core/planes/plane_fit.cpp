// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {

double PointMoments::meanSquareDistance(const Eigen::Vector3d& normal, double d) const {
  // Of the mean and of the scatter about it, each without the other's large numbers.
  const Eigen::Vector3d centroid = sum / count;
  const Eigen::Matrix3d scatter = outer / count - centroid * centroid.transpose();
  const double offset = normal.dot(centroid) + d;
  return std::max(0.0, normal.dot(scatter * normal)) + offset * offset;
}

bool fitPlane(const PointMoments& moments, PlaneFit& plane) {
  if (moments.count < 3.0) return false;
  const Eigen::Vector3d centroid = moments.sum / moments.count;
  const Eigen::Matrix3d scatter = moments.outer / moments.count - centroid * centroid.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::Vector3d& eigenvalues = solver.eigenvalues();  // ascending
  const double total = eigenvalues.sum();
  if (!(eigenvalues[1] > 1e-9 * total)) return false;

  plane.normal = solver.eigenvectors().col(0);
  plane.d = -plane.normal.dot(centroid);
  if (plane.d < 0.0) {
    plane.normal = -plane.normal;
    plane.d = -plane.d;
  }
  plane.centroid = centroid;
  plane.mean_square = std::max(0.0, eigenvalues[0]);
  plane.curvature = plane.mean_square / total;
  return plane.normal.allFinite() && std::isfinite(plane.d);
}

Eigen::Matrix4d PlaneFit::covariance(const PointMoments& moments, double sigma) const {
  // The residual n . p + d changes with a turn of the normal (t1, t2) and with d; the normal's length is
  // fixed.
  const Eigen::Vector3d t1 = normal.unitOrthogonal();
  const Eigen::Vector3d t2 = normal.cross(t1);
  Eigen::Matrix<double, 4, 3> tangent = Eigen::Matrix<double, 4, 3>::Zero();
  tangent.block<3, 1>(0, 0) = t1;
  tangent.block<3, 1>(0, 1) = t2;
  tangent(3, 2) = 1.0;
  Eigen::Matrix4d information;
  information.topLeftCorner<3, 3>() = moments.outer;
  information.topRightCorner<3, 1>() = moments.sum;
  information.bottomLeftCorner<1, 3>() = moments.sum.transpose();
  information(3, 3) = moments.count;
  const Eigen::Matrix3d reduced = tangent.transpose() * information * tangent;
  return sigma * sigma * tangent * reduced.inverse() * tangent.transpose();
}

}  // namespace line_plane_segmentation
