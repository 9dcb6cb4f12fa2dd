// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <optional>

#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// The depth image of an argument: the array itself or, of a masked array, a copy with 0 where it is masked.
/// @throws pybind11::type_error if it is not an array
pybind11::array depthArrayOf(const pybind11::object& depth);

/// A view of the pixels of a numpy array, which is not copied and must live as long.
/// @param depth            uint16 or float32 in either byte order, height x width; rows may be apart, pixels
/// not
/// @param depth_unit       [m] none: 0.001 for uint16, 1 for float32
/// @throws pybind11::type_error or value_error that says what is wrong with it
DepthView viewOf(const pybind11::array& depth, const std::optional<double>& depth_unit);

}  // namespace line_plane_segmentation
