// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace line_plane_segmentation {

/// Each function adds its class to the Python module.
void definePlane(pybind11::module& module);
void defineSegmentation(pybind11::module& module);
void defineSegmenter(pybind11::module& module);
void defineTracker(pybind11::module& module);

}  // namespace line_plane_segmentation
