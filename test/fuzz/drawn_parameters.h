// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_reader.h"
#include "line_plane_segmentation/parameters.h"
#include "location_parameters.h"

namespace line_plane_segmentation {

/// Calls `act(name, value, min, max)` for one of the parameters, which the bytes choose.
/// @param visit  calls a visitor for each of them, as visitParameters() does
template <typename Visit, typename Act>
void actOnOne(ByteReader& bytes, Visit visit, Act act) {
  int count = 0;
  visit([&count](const char*, const auto&, auto, auto) { ++count; });
  int index = bytes.integer(0, count - 1);
  visit([&](const char* name, auto& value, auto min, auto max) {
    if (index-- == 0) act(name, value, min, max);
  });
}

/// A preset with some parameters changed, all within their bounds; the defaults where there are no bytes.
Parameters drawParameters(ByteReader& bytes);

/// The same for tracking and orientations.
LocationParameters drawLocationParameters(ByteReader& bytes);

}  // namespace line_plane_segmentation
