// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <optional>

#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// Returns the depth image of an argument: the array or, for a masked array, a copy in which masked pixels
/// are 0.
/// @throws pybind11::type_error if it is not an array
pybind11::array depthArrayOf(const pybind11::object& depth);

/// Returns a view of a numpy array, which must outlive it.
/// @param depth       uint16 or float32 in either byte order, height x width; rows may have padding, pixels
/// not
/// @param depth_unit  [m] depth of one count; empty: 0.001 for uint16, 1 for float32
/// @throws pybind11::type_error or value_error with the reason
DepthView viewOf(const pybind11::array& depth, const std::optional<double>& depth_unit);

}  // namespace line_plane_segmentation
