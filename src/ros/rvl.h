// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// Decodes depth in the RVL format (Wilson, "Fast lossless depth image compression", ISS 2017).
/// @param data    32-bit words, little-endian; need not be aligned
/// @param size    [bytes] size of the data
/// @param pixels  number of pixels of the image
/// @param depth   output, `pixels` values; pixels without data are 0
/// @return false if the data is truncated or has more than `pixels` pixels
bool decodeRvl(const std::uint8_t* data, std::size_t size, std::size_t pixels, std::uint16_t* depth);

}  // namespace line_plane_segmentation
