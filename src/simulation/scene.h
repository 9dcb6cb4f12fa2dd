// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation::simulation {

/// A plane in the world frame: normal() . p + offset() = 0, with a unit normal.
using WorldPlane = Eigen::Hyperplane<double, 3>;

/// A convex polygon, visible only from the side to which its plane's normal points.
struct Face {
  std::vector<Eigen::Vector3d> vertices;  ///< [m] world, counterclockwise as seen from the visible side
  std::uint16_t label = 0;                ///< label of its plane, Scene::planes()[label - 1]
};

/// A curved surface, which has label 0: all p with |shape (p - center)| = 1.
struct CurvedBody {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< [m] world
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();  ///< [1/m]
  bool vault = false;  ///< a vaulted ceiling: only the upper half, visible from inside
};

/// Returns an ellipsoid with axes parallel to the world's.
/// @param radii  [m], positive
CurvedBody ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii);

/// A round, upright column of infinite height; floor and ceiling hide the parts beyond them.
/// @param foot  [m] a point on its axis
/// @param radius  [m], positive
CurvedBody column(const Eigen::Vector3d& foot, double radius);

/// Returns a barrel vault along the world's y axis.
/// @param center  [m] a point on its axis, at the height of the springing line
/// @param half_width,rise  [m], positive
CurvedBody vault(const Eigen::Vector3d& center, double half_width, double rise);

/// The visible world: flat faces and a few curved bodies, in a world frame with z up.
///
/// Each plane has one label, from 1 in the order of addition. Faces have the same label if they lie in the
/// same plane and face the same side, even if they do not touch: the parts of a wall around a door.
class Scene {
 public:
  /// Adds a convex polygon.
  /// @param vertices  [m] in the world frame, counterclockwise as seen from the visible side
  /// @return the label of its plane
  /// @throw std::invalid_argument if it is not planar and strictly convex, or has fewer than three vertices
  /// @throw std::length_error if all 16-bit labels are used
  std::uint16_t addPolygon(std::vector<Eigen::Vector3d> vertices);

  /// Adds the parallelogram `corner`, `corner + side`, `corner + side + other_side`, `corner + other_side`,
  /// visible from the side of `side` x `other_side`. Throws as addPolygon().
  std::uint16_t addRectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& side,
                             const Eigen::Vector3d& other_side);

  /// Adds the six faces of a box.
  /// @param pose  pose of the centre of its bottom face in the world
  /// @param size  [m] along the axes of `pose`, all positive
  void addBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size);

  /// Adds a curved surface; its pixels have label 0.
  void addCurvedBody(const CurvedBody& body) { curved_bodies_.push_back(body); }

  /// All faces, in order of insertion.
  const std::vector<Face>& faces() const { return faces_; }
  /// All curved surfaces, in order of insertion.
  const std::vector<CurvedBody>& curvedBodies() const { return curved_bodies_; }

  /// Planes by label: planes()[k - 1] has label k.
  const std::vector<WorldPlane>& planes() const { return planes_; }

 private:
  std::uint16_t labelOf(const WorldPlane& plane);

  std::vector<Face> faces_;
  std::vector<WorldPlane> planes_;
  std::vector<CurvedBody> curved_bodies_;
};

}  // namespace line_plane_segmentation::simulation
