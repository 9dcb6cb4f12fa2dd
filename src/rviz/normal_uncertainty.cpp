// SPDX-License-Identifier: BSD-3-Clause
#include "normal_uncertainty.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {

std::vector<Triangle> normalDisc(const Plane& plane, float length, float scale) {
  constexpr int kSectors = 32;
  const auto& coef = plane.coefficients.coef;
  const Eigen::Vector3d normal(coef[0], coef[1], coef[2]);
  Eigen::Matrix<double, 3, 2> tangent;
  tangent.col(0) = normal.unitOrthogonal();
  tangent.col(1) = normal.cross(tangent.col(0));
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> covariance(plane.covariance.data());
  const Eigen::Matrix2d of_normal = tangent.transpose() * covariance.topLeftCorner<3, 3>() * tangent;
  if (!of_normal.allFinite() || of_normal.trace() <= 0.0) return {};

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(of_normal);
  const Eigen::Vector2d deviations = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Matrix<double, 3, 2> half_axes = static_cast<double>(length) * static_cast<double>(scale) *
                                                tangent * axes.eigenvectors() * deviations.asDiagonal();
  const Eigen::Vector3d tip = Eigen::Vector3d(plane.centroid.x, plane.centroid.y, plane.centroid.z) +
                              static_cast<double>(length) * normal;
  const auto border = [&](int sector) -> Eigen::Vector3f {
    const double angle = 2.0 * M_PI * sector / kSectors;
    return (tip + half_axes * Eigen::Vector2d(std::cos(angle), std::sin(angle))).cast<float>();
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < kSectors; ++i) triangles.push_back({tip.cast<float>(), border(i), border(i + 1)});
  return triangles;
}

}  // namespace line_plane_segmentation
