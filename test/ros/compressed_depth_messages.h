// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CompressedImage.h>

#include <cstdint>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "rvl_encoder.h"

namespace line_plane_segmentation {

/// The bytes of one number as this machine stores it.
template <typename Number>
std::vector<std::uint8_t> bytesOfNumber(Number number) {
  std::vector<std::uint8_t> bytes(sizeof number);
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

inline void append(std::vector<std::uint8_t>& to, const std::vector<std::uint8_t>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// A message as the compressedDepth plugin makes it.
/// @param numbers  a pixel each: millimetres, or quantised inverse depth
/// @param format   "16UC1; compressedDepth png"
/// @param a, b     how inverse depth is quantised: depth = a / (number - b)
inline sensor_msgs::CompressedImage compressedDepth(const std::vector<std::uint16_t>& numbers, int width,
                                                    int height, const std::string& format, float a = 0.0F,
                                                    float b = 0.0F) {
  sensor_msgs::CompressedImage message;
  message.format = format;
  append(message.data, bytesOfNumber<std::int32_t>(0));
  append(message.data, bytesOfNumber(a));
  append(message.data, bytesOfNumber(b));
  if (format.find("rvl") != std::string::npos) {
    append(message.data, bytesOfNumber<std::int32_t>(width));
    append(message.data, bytesOfNumber<std::int32_t>(height));
    append(message.data, RvlEncoder::encode(numbers));
  } else {
    const cv::Mat image(height, width, CV_16UC1, const_cast<std::uint16_t*>(numbers.data()));
    std::vector<std::uint8_t> png;
    cv::imencode(".png", image, png);
    append(message.data, png);
  }
  return message;
}

}  // namespace line_plane_segmentation
