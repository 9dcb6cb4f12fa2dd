// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace line_plane_segmentation::simulation {

/// Path of a hand-held camera: smooth and slow, below 0.3 m/s and 30 degrees/s, with a slight tremor. Defined
/// for all times. The path is not periodic, but returns close to earlier poses.
class CameraPath {
 public:
  /// @param station  [m] centre of the path in the world frame; the camera stays within 0.6 m of it
  /// @param target   [m] point in the world frame that the camera mostly faces; not exactly above or below
  /// the station
  CameraPath(const Eigen::Vector3d& station, const Eigen::Vector3d& target, std::uint64_t seed);

  /// @param seconds  [s] time since the start
  /// @return the pose of the optical frame (x right, y down, z forward) in the world (z up)
  Eigen::Isometry3d pose(double seconds) const;

 private:
  /// Sum of a slow oscillation and a fast, small one.
  struct Sway {
    double amplitude = 0.0;
    double tremor = 0.0;
    double frequency = 0.0;  // [rad/s]
    double phase = 0.0;      // [rad]
    double at(double seconds) const;
  };

  Eigen::Vector3d station_;
  double heading_ = 0.0;       // [rad] about the world's z axis, 0 along x
  double elevation_ = 0.0;     // [rad] above the horizon
  std::array<Sway, 6> sways_;  // x, y, z [m]; heading, elevation, roll [rad]
};

/// The pose of an optical frame that faces the given direction.
/// @param heading    [rad] about the world's z axis, 0 along x
/// @param elevation  [rad] above the horizon
/// @param roll  [rad] rotation about the optical axis, clockwise as seen from behind the camera
Eigen::Isometry3d lookingAlong(const Eigen::Vector3d& position, double heading, double elevation,
                               double roll);

}  // namespace line_plane_segmentation::simulation
