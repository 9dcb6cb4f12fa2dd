// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// Decodes depth in the RVL format (Wilson, "Fast lossless depth image compression", ISS 2017).
/// @param data    words of 32 bits, little-endian; need not be aligned
/// @param size    [bytes]
/// @param depth   `pixels` numbers; those after the end of the data are 0
/// @return false if the data ends too soon, or has more pixels than that
bool decodeRvl(const std::uint8_t* data, std::size_t size, std::size_t pixels, std::uint16_t* depth);

}  // namespace line_plane_segmentation
