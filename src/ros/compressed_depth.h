// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <string>

namespace line_plane_segmentation {

/// Decoders of depth images compressed by image_transport's plugins: `compressedDepth` (PNG or RVL; 16UC1, or
/// 32FC1 as quantised inverse depth), and `compressed` if it holds a 16-bit PNG. They are decoded here
/// because Debian has no compressedDepth plugin, and because bags contain the compressed messages.

/// Reads header, encoding and size of the image from the first bytes; the data of the result is empty.
/// @return null if the message is not a compressed depth image
sensor_msgs::Image::Ptr describeCompressedDepth(const sensor_msgs::CompressedImage& message);

/// Decodes the pixels into `image`, whose memory is reused. Invalid depths are 0 (16UC1) or NaN (32FC1).
/// @param max_pixels  larger images are refused before memory is allocated
/// @return false if the message cannot be decoded; the content of `image` is then undefined
bool decodeCompressedDepth(const sensor_msgs::CompressedImage& message, std::uint64_t max_pixels,
                           sensor_msgs::Image& image);

/// Returns the image topic of a compressed topic, "/depth/image_raw" for
/// "/depth/image_raw/compressedDepth"; empty if it is not such a topic.
std::string rawTopicOf(const std::string& compressed_topic);

}  // namespace line_plane_segmentation
