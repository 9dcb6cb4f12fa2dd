// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <boost/endian/conversion.hpp>
#include <boost/make_shared.hpp>
#include <cstddef>
#include <string>

namespace line_plane_segmentation {

/// Returns an image message of this size with packed rows, all 0, in host byte order.
inline sensor_msgs::Image::Ptr makeImage(const std_msgs::Header& header, const std::string& encoding,
                                         int width, int height, std::size_t bytes_per_pixel) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header = header;
  image->encoding = encoding;
  image->width = static_cast<std::uint32_t>(width);
  image->height = static_cast<std::uint32_t>(height);
  image->step = static_cast<std::uint32_t>(static_cast<std::size_t>(width) * bytes_per_pixel);
  image->is_bigendian = boost::endian::order::native == boost::endian::order::big ? 1 : 0;
  image->data.resize(static_cast<std::size_t>(image->step) * image->height);
  return image;
}

}  // namespace line_plane_segmentation
