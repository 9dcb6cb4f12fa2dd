// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation::simulation {

/// A plane of the world frame: normal() . p + offset() = 0, the normal a unit vector.
using WorldPlane = Eigen::Hyperplane<double, 3>;

/// A flat, convex part of a surface, seen only from the side to which its plane's normal points.
struct Face {
  std::vector<Eigen::Vector3d> vertices;  ///< [m] world, counterclockwise as seen from the visible side
  std::uint16_t label = 0;                ///< of its plane, Scene::planes()[label - 1]
};

/// A curved surface, which belongs to no plane: all p with |shape (p - center)| = 1.
struct CurvedBody {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< [m] world
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();  ///< [1/m]
  bool vault = false;  ///< seen from within, and only its upper half is there: a vaulted ceiling
};

/// An ellipsoid with its axes along those of the world.
/// @param radii  [m], positive
CurvedBody ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii);

/// A round, upright column of infinite height; floor and ceiling hide the parts beyond them.
/// @param foot    [m] a point of its axis
/// @param radius  [m], positive
CurvedBody column(const Eigen::Vector3d& foot, double radius);

/// A barrel vault along the world's y axis.
/// @param center  [m] a point of its axis, at the height where it springs from the walls
/// @param half_width,rise  [m], positive
CurvedBody vault(const Eigen::Vector3d& center, double half_width, double rise);

/// The visible world: flat faces and a few curved bodies, in a world frame with z up.
///
/// Each plane has one label, from 1 in the order of addition. Faces have the same label if they lie in the
/// same plane and face the same side, even if they do not touch: the parts of a wall around a door.
class Scene {
 public:
  /// Adds a convex polygon.
  /// @param vertices  [m] world, counterclockwise as seen from the side from which it is visible
  /// @return its plane's label
  /// @throw std::invalid_argument  if it is not flat and strictly convex, or has under three vertices
  /// @throw std::length_error      if there are no more 16-bit labels
  std::uint16_t addPolygon(std::vector<Eigen::Vector3d> vertices);

  /// Adds the parallelogram `corner`, `corner + side`, `corner + side + other_side`, `corner + other_side`,
  /// visible from the side of `side` x `other_side`. Throws as addPolygon().
  std::uint16_t addRectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& side,
                             const Eigen::Vector3d& other_side);

  /// Adds the six faces of a box.
  /// @param pose  of the middle of its bottom in the world
  /// @param size  [m] along the axes of `pose`, all positive
  void addBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size);

  void addCurvedBody(const CurvedBody& body) { curved_bodies_.push_back(body); }

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<CurvedBody>& curvedBodies() const { return curved_bodies_; }

  /// planes()[k - 1] has label k.
  const std::vector<WorldPlane>& planes() const { return planes_; }

 private:
  std::uint16_t labelOf(const WorldPlane& plane);

  std::vector<Face> faces_;
  std::vector<WorldPlane> planes_;
  std::vector<CurvedBody> curved_bodies_;
};

}  // namespace line_plane_segmentation::simulation
