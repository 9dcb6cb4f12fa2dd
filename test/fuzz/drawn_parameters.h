// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_reader.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/ros/location_parameters.h"

namespace line_plane_segmentation {

/// A preset with some parameters changed, all within their bounds; the defaults where there are no bytes.
Parameters drawParameters(ByteReader& bytes);

/// The same for tracking and orientations.
LocationParameters drawLocationParameters(ByteReader& bytes);

}  // namespace line_plane_segmentation
