// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace line_plane_segmentation {

/// Orientation of a plane relative to gravity.
enum class Orientation : std::uint8_t {
  kUnknown,         ///< the direction of gravity is unknown
  kHorizontalUp,    ///< visible from above: floor, table
  kHorizontalDown,  ///< visible from below: ceiling
  kVertical,        ///< wall
  kSlanted,         ///< all others
};

constexpr int kOrientationCount = 5;

/// Returns the name: "unknown", "horizontal_up", "horizontal_down", "vertical", "slanted".
const char* nameOf(Orientation orientation);

/// Classifies a plane by the angle between its normal and the vertical.
/// @param normal     unit normal of the visible side
/// @param up         unit vector against gravity, in the same frame
/// @param tolerance  [rad] largest deviation of a horizontal or vertical plane, 0 to pi / 4
Orientation orientationOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& up, double tolerance);

}  // namespace line_plane_segmentation
