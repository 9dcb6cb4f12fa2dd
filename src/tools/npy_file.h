// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// True if the bytes begin as those of a NumPy array file (.npy) do.
bool isNpy(const std::vector<unsigned char>& bytes);

/// Decodes a two-dimensional array of uint16, float32 or float64 in C order, as numpy.save() writes it.
/// @param name  for error messages
/// @return CV_16UC1, CV_32FC1 or CV_64FC1
/// @throws BadInput if it is of another kind or incomplete, or has more than `max_pixels` elements
cv::Mat decodeNpy(const std::vector<unsigned char>& bytes, const std::string& name, std::int64_t max_pixels);

}  // namespace line_plane_segmentation
