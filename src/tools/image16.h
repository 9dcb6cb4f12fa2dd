// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace line_plane_segmentation {

/// Reads an image of one 16-bit channel, as depth and label images are.
/// Whatever the image libraries print while they read it is kept from stderr, so it must not run
/// while another thread writes there.
/// @throws BadInput if there is no such file, it is broken or empty, or of another kind
cv::Mat readImage16(const std::filesystem::path& file);

}  // namespace line_plane_segmentation
