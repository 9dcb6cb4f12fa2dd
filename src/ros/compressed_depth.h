// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <string>

namespace line_plane_segmentation {

/// Depth images as image_transport's plugins compress them: `compressedDepth` (PNG or RVL; 16UC1, or 32FC1 as
/// quantised inverse depth), and `compressed` where that holds a 16-bit PNG. Decoded here because Debian has
/// no compressedDepth plugin, and because bags hold these messages as they are.

/// Returns the image's header, encoding and size, read from the first bytes; its data is empty. Null if these
/// are not a compressed depth image.
sensor_msgs::Image::Ptr describeCompressedDepth(const sensor_msgs::CompressedImage& message);

/// Decodes the pixels into `image`, whose memory is reused. Pixels without depth are 0 (16UC1) or NaN
/// (32FC1).
/// @param max_pixels  larger images are refused before memory is taken for them
/// @return false if the message cannot be decoded: `image` is then not to be used
bool decodeCompressedDepth(const sensor_msgs::CompressedImage& message, std::uint64_t max_pixels,
                           sensor_msgs::Image& image);

/// Returns the image topic that a compressed topic belongs to, "/depth/image_raw" for
/// "/depth/image_raw/compressedDepth"; empty if it is not such a topic.
std::string rawTopicOf(const std::string& compressed_topic);

}  // namespace line_plane_segmentation
