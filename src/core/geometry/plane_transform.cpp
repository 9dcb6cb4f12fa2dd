// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

SegmentedPlane transformed(const SegmentedPlane& plane, const RigidTransform& target_from_optical) {
  SegmentedPlane result = plane;
  result.normal = target_from_optical.linear() * plane.normal;
  // n . p + d is the same for the same point, and q = R p + t: d' = d - R n . t.
  result.d = plane.d - result.normal.dot(target_from_optical.translation());
  result.centroid = target_from_optical * plane.centroid;

  Eigen::Matrix4d jacobian = Eigen::Matrix4d::Identity();
  jacobian.topLeftCorner<3, 3>() = target_from_optical.linear();
  jacobian.bottomLeftCorner<1, 3>() =
      -target_from_optical.translation().transpose() * target_from_optical.linear();
  result.covariance = jacobian * plane.covariance * jacobian.transpose();
  return result;
}

}  // namespace line_plane_segmentation
