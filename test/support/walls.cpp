// SPDX-License-Identifier: BSD-3-Clause
#include "support/walls.h"

#include <Eigen/Dense>
#include <algorithm>

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kFewestPixels = 10;

/// A wall in the optical frame, ready to be met by rays.
struct Target {
  Eigen::Vector3d corner, normal;
  Eigen::Matrix<double, 2, 3> to_sides;  // takes a vector in the wall to multiples of its two sides

  Target(const Wall& wall, const Eigen::Isometry3d& world_in_camera) : corner(world_in_camera * wall.corner) {
    Eigen::Matrix<double, 3, 2> sides;
    sides << world_in_camera.linear() * wall.side, world_in_camera.linear() * wall.other_side;
    normal = sides.col(0).cross(sides.col(1)).normalized();
    to_sides = (sides.transpose() * sides).inverse() * sides.transpose();
    if (normal.dot(corner) > 0.0) normal = -normal;
  }

  double distance() const { return -normal.dot(corner); }

  /// Where the ray meets the wall: its depth, or 0.
  double depthAlong(const Eigen::Vector3d& ray) const {
    const double z = normal.dot(corner) / normal.dot(ray);
    const Eigen::Vector2d at = to_sides * (z * ray - corner);
    return z > 0.0 && at.minCoeff() >= 0.0 && at.maxCoeff() <= 1.0 ? z : 0.0;
  }
};

}  // namespace

int WallPicture::planeOf(std::size_t wall) const {
  const auto found = std::find(wall_of.begin(), wall_of.end(), wall);
  return found == wall_of.end() ? -1 : static_cast<int>(found - wall_of.begin());
}

WallPicture pictureOf(const std::vector<Wall>& walls, const Eigen::Isometry3d& camera_in_world,
                      const CameraIntrinsics& camera, int width, int height) {
  const Eigen::Isometry3d world_in_camera = camera_in_world.inverse();
  std::vector<SegmentedPlane> planes(walls.size());
  std::vector<int> wall_at(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
  std::vector<Target> targets;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    targets.emplace_back(walls[w], world_in_camera);
    planes[w].normal = targets[w].normal;
    planes[w].d = targets[w].distance();
  }
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      double nearest = 0.0;
      int seen = -1;
      for (std::size_t w = 0; w < walls.size(); ++w) {
        const double z = walls[w].there ? targets[w].depthAlong(ray) : 0.0;
        if (z <= 0.0 || (seen >= 0 && z >= nearest)) continue;
        nearest = z;
        seen = static_cast<int>(w);
      }
      if (seen < 0) continue;
      wall_at[static_cast<std::size_t>(v * width + u)] = seen;
      SegmentedPlane& plane = planes[static_cast<std::size_t>(seen)];
      ++plane.inliers;
      plane.centroid += nearest * ray;
      plane.area += nearest * nearest * nearest / (plane.d * camera.fx * camera.fy);
    }
  }

  WallPicture picture;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (planes[w].inliers >= kFewestPixels) picture.wall_of.push_back(w);
  }
  std::stable_sort(picture.wall_of.begin(), picture.wall_of.end(),
                   [&](std::size_t a, std::size_t b) { return planes[a].inliers > planes[b].inliers; });
  picture.segmentation.width = width;
  picture.segmentation.height = height;
  for (const std::size_t w : picture.wall_of) {
    SegmentedPlane& plane = planes[w];
    plane.centroid /= plane.inliers;
    plane.label = static_cast<std::uint16_t>(picture.segmentation.planes.size() + 1);
    picture.segmentation.planes.push_back(plane);
  }
  for (const int wall : wall_at) {
    const int plane = wall < 0 ? -1 : picture.planeOf(static_cast<std::size_t>(wall));
    picture.segmentation.labels.push_back(static_cast<std::uint16_t>(plane + 1));
  }
  return picture;
}

}  // namespace line_plane_segmentation
