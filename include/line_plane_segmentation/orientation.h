// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace line_plane_segmentation {

/// How a plane lies against gravity.
enum class Orientation : std::uint8_t {
  kUnknown,         ///< nobody knows where up is
  kHorizontalUp,    ///< a floor, a table: its visible side looks up
  kHorizontalDown,  ///< a ceiling: its visible side looks down
  kVertical,        ///< a wall
  kSlanted,
};

constexpr int kOrientationCount = 5;

/// The orientation's name: "unknown", "horizontal_up", "horizontal_down", "vertical", "slanted".
const char* nameOf(Orientation orientation);

/// @param normal     unit, toward the visible side
/// @param up         unit, in the same frame
/// @param tolerance  [rad] from 0 to pi / 4: how far a horizontal or vertical plane may be off
Orientation orientationOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& up, double tolerance);

}  // namespace line_plane_segmentation
