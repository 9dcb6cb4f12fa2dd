// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace line_plane_segmentation {

/// Eigen types of the public interface that Eigen would otherwise align to the widest vector register that
/// the compiler's flags allow. Their size and alignment would then differ between a program built with
/// `-mavx2` and a library built without it. Eigen::Vector3d and Eigen::Vector3f are never aligned and are
/// used as they are. Conversions from and to Eigen's default types are implicit.
using Covariance2d = Eigen::Matrix<double, 2, 2, Eigen::DontAlign>;
using Covariance4d = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

/// Rotation and translation without alignment requirements, for the same reason as Covariance2d.
using RigidTransform = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

}  // namespace line_plane_segmentation
