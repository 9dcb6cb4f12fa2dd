// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace line_plane_segmentation {

/// Properties that an image file's header states.
struct ImageHeader {
  std::int64_t width = 0;   ///< [px]
  std::int64_t height = 0;  ///< [px]
  int bits = 0;             ///< per channel, 0 if not known
  int channels = 0;         ///< 0 if not known
};

/// Reads the header of a PNG, TIFF, EXR or binary PGM from the first bytes of the file, without an image
/// library, because these allocate memory for the stated size.
/// @return nothing if the bytes are none of these formats or the header is incomplete
std::optional<ImageHeader> readImageHeader(const std::vector<unsigned char>& bytes);

/// True if the bytes begin as those of a PNG do.
bool isPng(const std::vector<unsigned char>& bytes);

}  // namespace line_plane_segmentation
