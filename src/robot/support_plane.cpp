// SPDX-License-Identifier: BSD-3-Clause
#include "support_plane.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace line_plane_segmentation {
namespace {

// The origin is the plane's point below the camera.
Eigen::Isometry3d planeFromOptical(const SegmentedPlane& plane) {
  const Eigen::Vector3d x = plane.normal.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes << x, plane.normal.cross(x), plane.normal;
  Eigen::Isometry3d plane_from_optical = Eigen::Isometry3d::Identity();
  plane_from_optical.linear() = axes.transpose();
  plane_from_optical.translation().z() = plane.d;
  return plane_from_optical;
}

}  // namespace

bool SupportPlane::covers(float x, float y) const {
  if (hull.size() < 3) return false;
  // The hull is convex: inside, the point is on the same side of all edges.
  bool left = false, right = false;
  for (std::size_t i = 0, j = hull.size() - 1; i < hull.size(); j = i++) {
    const cv::Point2f edge = hull[i] - hull[j];
    const float side = edge.x * (y - hull[j].y) - edge.y * (x - hull[j].x);
    left |= side > 0.0F;
    right |= side < 0.0F;
    if (left && right) return false;
  }
  return true;
}

SupportPlane supportPlane(const Segmentation& segmentation, std::size_t index,
                          const CameraIntrinsics& camera) {
  constexpr double kEdgeOn = -1e-3;  // closer to parallel, the ray's intersection with the plane is undefined
  const SegmentedPlane& plane = segmentation.planes[index];
  SupportPlane support;
  support.index = index;
  support.label = plane.label;
  const Eigen::Isometry3d plane_from_optical = planeFromOptical(plane);
  support.plane_from_optical = plane_from_optical.cast<float>();

  std::vector<cv::Point2f> border;
  const auto add_pixel = [&](int u, int v) {
    const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
    const double along = plane.normal.dot(ray);
    if (along > kEdgeOn) return;
    const Eigen::Vector3d point = plane_from_optical * (-plane.d / along * ray);
    border.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
  };
  const auto width = static_cast<std::ptrdiff_t>(segmentation.width);
  for (int v = 0; v < segmentation.height; ++v) {
    const auto row = segmentation.labels.begin() + v * width;
    const auto first = std::find(row, row + width, plane.label);
    if (first == row + width) continue;
    const auto last =
        std::find(std::make_reverse_iterator(row + width), std::make_reverse_iterator(first), plane.label);
    add_pixel(static_cast<int>(first - row), v);
    add_pixel(static_cast<int>(last.base() - row) - 1, v);
  }
  if (border.size() >= 3) cv::convexHull(border, support.hull);
  return support;
}

}  // namespace line_plane_segmentation
