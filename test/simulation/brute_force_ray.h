// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "scene.h"

namespace line_plane_segmentation::simulation {

/// What a ray meets first.
struct Hit {
  double depth = std::numeric_limits<double>::infinity();  ///< [m] along the optical axis
  std::uint16_t label = 0;

  bool missed() const { return std::isinf(depth); }
  void keepNearer(double other_depth, std::uint16_t other_label) {
    if (other_depth > 0.0 && other_depth < depth) *this = {other_depth, other_label};
  }
};

/// The slow twin of render(), by other formulas: in the world frame, triangle by triangle (Moeller and
/// Trumbore 1997), and the textbook's quadratic equation for curved bodies.
class BruteForceRay {
 public:
  BruteForceRay(const Eigen::Isometry3d& camera, const CameraIntrinsics& k, int u, int v)
      : origin_(camera.translation()),
        direction_(camera.linear() * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0)) {}

  Hit cast(const Scene& scene) const {
    Hit hit;
    for (const Face& face : scene.faces()) {
      for (std::size_t i = 2; i < face.vertices.size(); ++i) {
        hit.keepNearer(meetTriangle(face.vertices[0], face.vertices[i - 1], face.vertices[i]), face.label);
      }
    }
    for (const CurvedBody& body : scene.curvedBodies()) hit.keepNearer(meetBody(body), 0);
    return hit;
  }

 private:
  /// @return 0 if the triangle is missed or seen from behind
  double meetTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;
    const Eigen::Vector3d p = direction_.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant <= 0.0) return 0.0;
    const Eigen::Vector3d s = origin_ - a;
    const double along_ab = s.dot(p) / determinant;
    const Eigen::Vector3d q = s.cross(ab);
    const double along_ac = direction_.dot(q) / determinant;
    const bool inside = along_ab >= 0.0 && along_ac >= 0.0 && along_ab + along_ac <= 1.0;
    return inside ? ac.dot(q) / determinant : 0.0;
  }

  double meetBody(const CurvedBody& body) const {
    const Eigen::Vector3d o = body.shape * (origin_ - body.center);
    const Eigen::Vector3d q = body.shape * direction_;
    const double a = q.squaredNorm();
    const double b = 2.0 * o.dot(q);
    const double c = o.squaredNorm() - 1.0;
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0 || (c < 0.0) != body.vault) return 0.0;
    const double root = std::sqrt(discriminant);
    const double depth = (body.vault ? -b + root : -b - root) / (2.0 * a);
    const bool below = (origin_ + depth * direction_).z() < body.center.z();
    return body.vault && below ? 0.0 : depth;
  }

  Eigen::Vector3d origin_;
  Eigen::Vector3d direction_;
};

}  // namespace line_plane_segmentation::simulation
