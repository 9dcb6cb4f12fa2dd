// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/row_kernels.h"

namespace line_plane_segmentation {

/// Marks the columns of a row where valid depth begins or ends; the first one if it is valid.
void markValidityChanges(const float* z, int count, std::uint8_t* marks);

/// Marks the columns where a hole of 2 to `max_hole` pixels ends above a valid pixel of row v.
/// @param last_valid  row of the last valid pixel in each column; updated
/// @param holes       [pixel] length of the hole in each column, where one is marked
void markHoleEnds(const float* z, int count, int v, int max_hole, int* last_valid, int* holes,
                  std::uint8_t* marks);

/// Fills holes of a single pixel between two valid ones, as HoleFiller does, in single precision. Most holes
/// of an image are such.
/// @param before, after  the neighbours of each pixel: z, moved by one column or one row to either side
/// @param tolerance      noise model times the largest difference of neighbours on one surface, in sigma_z
/// @param filled         receives 1 where a pixel is filled; the others are left as they are
void fillSingleHoles(const float* before, const float* after, int count, const RowNoise& tolerance, float* z,
                     std::uint8_t* filled);

/// Sets the depth of marked pixels to 0.
void clearMarked(const std::uint8_t* marks, std::size_t count, float* z);

/// Sets the label of pixels without depth to 0.
void clearWithoutDepth(const float* z, std::size_t count, std::uint16_t* labels);

}  // namespace line_plane_segmentation
