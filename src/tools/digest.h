// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Returns the SHA-256 of the bytes in hexadecimal digits, as the program sha256sum prints it.
std::string sha256(const std::vector<unsigned char>& bytes);

}  // namespace line_plane_segmentation
