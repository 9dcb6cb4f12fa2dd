// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

namespace line_plane_segmentation {

/// Default of the largest accepted image [px].
constexpr std::int64_t kDefaultMaxPixels = std::int64_t{1} << 24;

/// Reads a whole file.
/// @throws BadInput if it does not exist, is not a regular file, or cannot be read
std::vector<unsigned char> readFile(const std::filesystem::path& file);

/// Checks that a file is a depth image that decodeDepth() accepts, without decoding the pixels of a PNG:
/// format, size, bit depth, channels, and whether the file is complete. Damaged pixel data is only found by
/// decodeDepth().
/// @throws BadInput with the reason
void checkDepthFile(const std::filesystem::path& file, std::int64_t max_pixels = kDefaultMaxPixels);

/// Decodes a depth image: 16 bit, 32-bit float or 64-bit float (converted to 32), one channel. Formats: .npy
/// and the formats of OpenCV, such as PNG, TIFF, EXR and PGM. stderr is redirected to suppress messages of
/// the image libraries, so no other thread may write to it.
/// @param file  for error messages
/// @return CV_16UC1 or CV_32FC1
/// @throws BadInput if the image is damaged, of another kind, or has more than `max_pixels` pixels; that is
/// checked before memory for the pixels is allocated
cv::Mat decodeDepth(const std::vector<unsigned char>& bytes, const std::filesystem::path& file,
                    std::int64_t max_pixels = kDefaultMaxPixels);

/// Reads an image of one 16-bit channel, such as a label image.
/// @throws BadInput as readFile() and decodeDepth()
cv::Mat readImage16(const std::filesystem::path& file, std::int64_t max_pixels = kDefaultMaxPixels);

}  // namespace line_plane_segmentation
