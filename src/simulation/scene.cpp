// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace line_plane_segmentation::simulation {
namespace {

/// Under this distance [m], or difference of a unit normal, two things are the same.
constexpr double kSame = 1e-9;

constexpr std::size_t kMaxLabels = 65534;  // 65535 says "do not judge" in truth images

using Vertices = std::vector<Eigen::Vector3d>;

const Eigen::Vector3d& cyclic(const Vertices& vertices, std::size_t i) {
  return vertices[i % vertices.size()];
}

/// Newell's normal: not unit, long as twice the polygon's area.
Eigen::Vector3d areaVector(const Vertices& vertices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    sum += (vertices[i] - vertices[0]).cross(cyclic(vertices, i + 1) - vertices[0]);
  }
  return sum;
}

bool turnsLeftAt(const Vertices& vertices, std::size_t i, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d before = cyclic(vertices, i + 1) - cyclic(vertices, i);
  const Eigen::Vector3d after = cyclic(vertices, i + 2) - cyclic(vertices, i + 1);
  return before.cross(after).dot(normal) > kSame * kSame;
}

/// Left turns alone would also let a star pass: a convex polygon lies to the left of each of its sides.
bool liesLeftOfSide(const Vertices& vertices, std::size_t i, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d side = cyclic(vertices, i + 1) - vertices[i];
  for (const Eigen::Vector3d& vertex : vertices) {
    if (side.cross(vertex - vertices[i]).dot(normal) < -kSame) return false;
  }
  return true;
}

WorldPlane planeOf(const Vertices& vertices) {
  if (vertices.size() < 3) throw std::invalid_argument("a polygon needs three vertices");
  const Eigen::Vector3d normal = areaVector(vertices).normalized();
  const WorldPlane plane(normal, vertices[0]);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!(plane.absDistance(vertices[i]) < kSame)) throw std::invalid_argument("the polygon is not flat");
    if (!turnsLeftAt(vertices, i, normal) || !liesLeftOfSide(vertices, i, normal)) {
      throw std::invalid_argument("the polygon is not convex");
    }
  }
  return plane;
}

}  // namespace

CurvedBody ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii) {
  return {center, radii.cwiseInverse().asDiagonal(), false};
}

CurvedBody column(const Eigen::Vector3d& foot, double radius) {
  return {foot, Eigen::Vector3d(1.0 / radius, 1.0 / radius, 0.0).asDiagonal(), false};
}

CurvedBody vault(const Eigen::Vector3d& center, double half_width, double rise) {
  return {center, Eigen::Vector3d(1.0 / half_width, 0.0, 1.0 / rise).asDiagonal(), true};
}

std::uint16_t Scene::addPolygon(std::vector<Eigen::Vector3d> vertices) {
  const std::uint16_t label = labelOf(planeOf(vertices));
  faces_.push_back({std::move(vertices), label});
  return label;
}

std::uint16_t Scene::addRectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& side,
                                  const Eigen::Vector3d& other_side) {
  return addPolygon({corner, corner + side, corner + side + other_side, corner + other_side});
}

void Scene::addBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size) {
  // Corner i has its x, y and z at the far end where bits 0, 1 and 2 of i are set. The faces share the
  // corners bit by bit, so that no ray slips through between them.
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d local((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                                (i & 4) != 0 ? 1.0 : 0.0);
    corners.push_back(pose * local.cwiseProduct(size));
  }
  constexpr std::size_t kFaces[6][4] = {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4},
                                        {3, 2, 6, 7}, {1, 3, 7, 5}, {2, 0, 4, 6}};
  for (const auto& face : kFaces) {
    addPolygon({corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]});
  }
}

std::uint16_t Scene::labelOf(const WorldPlane& plane) {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if ((planes_[i].normal() - plane.normal()).norm() < kSame &&
        std::abs(planes_[i].offset() - plane.offset()) < kSame) {
      return static_cast<std::uint16_t>(i + 1);
    }
  }
  if (planes_.size() == kMaxLabels) throw std::length_error("the scene has no more labels");
  planes_.push_back(plane);
  return static_cast<std::uint16_t>(planes_.size());
}

}  // namespace line_plane_segmentation::simulation
