// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Reads intrinsics [px] from (fx, fy, cx, cy) or a 3x3 camera matrix: any sequence or array of numbers.
/// @throws pybind11::type_error if `camera` has another form
/// @throws pybind11::value_error if these are not the intrinsics of a pinhole camera without skew
CameraIntrinsics intrinsicsOf(const pybind11::object& camera);

/// Reads a rigid transform from a 4x4 matrix, or from its upper three rows.
/// @param name  name of the argument, for error messages
/// @throws pybind11::value_error if the matrix is not a rotation and a translation
RigidTransform rigidTransformOf(const pybind11::object& matrix, const char* name);

/// Reads a vector of three numbers and normalises it.
/// @throws pybind11::value_error if its length is 0 or not finite
Eigen::Vector3d directionOf(const pybind11::object& vector, const char* name);

}  // namespace line_plane_segmentation
