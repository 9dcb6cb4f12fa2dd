// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// What is fuzzed. Each takes any bytes, and expects what the package promises with gtest's macros.

/// Depth images and camera_infos, as bytes say or good ones with changes; parameters within their bounds.
void tryFrame(const std::uint8_t* data, std::size_t size);

/// The same for organised clouds.
void tryCloud(const std::uint8_t* data, std::size_t size);

/// Parameters of any value, by every way that they come in, and a good frame with what was made of them.
void tryParameters(const std::uint8_t* data, std::size_t size);

}  // namespace line_plane_segmentation
