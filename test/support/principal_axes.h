// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>
#include <vector>

namespace line_plane_segmentation {

/// How points spread, by singular values of the centred points themselves: another way than moments and
/// eigenvalues.
struct PrincipalAxes {
  Eigen::Vector3d centroid;
  Eigen::Vector3d normal;     ///< unit, along which they spread least
  Eigen::Vector3d variances;  ///< [m²] the largest first

  double curvature() const { return variances[2] / variances.sum(); }
};

/// @param points  at least one
inline PrincipalAxes principalAxesOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = points[i];
  const Eigen::Vector3d centroid = matrix.colwise().mean();
  matrix.rowwise() -= centroid.transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinV);
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
  variances.head(svd.singularValues().size()) =
      svd.singularValues().array().square() / static_cast<double>(points.size());
  return {centroid, svd.matrixV().rightCols<1>(), variances};
}

}  // namespace line_plane_segmentation
