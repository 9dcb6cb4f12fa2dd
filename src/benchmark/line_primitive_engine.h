// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "engine.h"
#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// This package's method: from the depth image to labels of full resolution, planes and outlines.
std::unique_ptr<Engine> makeLinePrimitiveEngine(const Parameters& parameters);

}  // namespace line_plane_segmentation
