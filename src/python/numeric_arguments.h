// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/eigen_types.h"

namespace line_plane_segmentation {

/// The intrinsics from (fx, fy, cx, cy) or a 3x3 camera matrix, as any sequence or array of numbers [px].
/// @throws pybind11::type_error if `camera` is neither of them
/// @throws pybind11::value_error if no pinhole camera without skew has these numbers
CameraIntrinsics intrinsicsOf(const pybind11::object& camera);

/// The rigid motion of a 4x4 matrix, or of its upper three rows.
/// @param name  of the argument, for the messages
/// @throws pybind11::value_error if it is not a rotation and a translation
RigidTransform rigidTransformOf(const pybind11::object& matrix, const char* name);

/// A direction of three numbers, brought to length 1.
/// @throws pybind11::value_error if it has no direction
Eigen::Vector3d directionOf(const pybind11::object& vector, const char* name);

}  // namespace line_plane_segmentation
