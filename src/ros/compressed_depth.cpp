// SPDX-License-Identifier: BSD-3-Clause
#include "compressed_depth.h"

#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <boost/make_shared.hpp>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "rvl.h"

namespace line_plane_segmentation {
namespace {

namespace enc = sensor_msgs::image_encodings;

constexpr std::array<std::uint8_t, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kPngSizes = 16;  // [bytes] from the signature to width and height
constexpr std::size_t kConfigSize =
    12;  // compressedDepth's own header: a format, and the quantisation of floats
constexpr std::size_t kRvlSizes = 8;

enum class Codec { kNone, kPng, kRvl };

/// Format of a message, and positions of its parts.
struct MessageLayout {
  Codec codec = Codec::kNone;
  std::string encoding;
  std::size_t start = 0;  // [bytes] offset of the PNG or of the RVL data
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  float quantisation_a = 0.0F;  // for 32FC1: depth = a / (number - b)
  float quantisation_b = 0.0F;
};

template <typename Number>
Number littleEndianAt(const std::vector<std::uint8_t>& data, std::size_t at) {
  std::uint32_t bits;
  std::memcpy(&bits, data.data() + at, sizeof bits);
  boost::endian::little_to_native_inplace(bits);
  Number number;
  static_assert(sizeof number == sizeof bits, "numbers of 32 bits");
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

std::uint32_t bigEndianAt(const std::vector<std::uint8_t>& data, std::size_t at) {
  return boost::endian::endian_reverse(littleEndianAt<std::uint32_t>(data, at));
}

bool isPngAt(const std::vector<std::uint8_t>& data, std::size_t at) {
  return data.size() >= at + kPngSizes + 8 && std::equal(kPngSignature.begin(), kPngSignature.end(),
                                                         data.begin() + static_cast<std::ptrdiff_t>(at));
}

std::string encodingOf(const std::string& format) {
  const std::string encoding = format.substr(0, format.find(';'));
  return encoding.substr(0, encoding.find(' '));
}

MessageLayout layoutOf(const sensor_msgs::CompressedImage& message) {
  const std::vector<std::uint8_t>& data = message.data;
  MessageLayout layout;
  layout.encoding = encodingOf(message.format);
  const bool is_float = layout.encoding == enc::TYPE_32FC1;
  if (!is_float && layout.encoding != enc::TYPE_16UC1 && layout.encoding != enc::MONO16) return layout;
  const bool has_config = message.format.find("compressedDepth") != std::string::npos;
  layout.start = has_config ? kConfigSize : 0;
  if (isPngAt(data, layout.start)) {
    layout.width = bigEndianAt(data, layout.start + kPngSizes);
    layout.height = bigEndianAt(data, layout.start + kPngSizes + 4);
    layout.codec = Codec::kPng;
  } else if (has_config && data.size() >= kConfigSize + kRvlSizes &&
             message.format.find("rvl") != std::string::npos) {
    layout.width = littleEndianAt<std::uint32_t>(data, kConfigSize);
    layout.height = littleEndianAt<std::uint32_t>(data, kConfigSize + 4);
    layout.start += kRvlSizes;
    layout.codec = Codec::kRvl;
  }
  if (is_float && has_config && layout.codec != Codec::kNone) {
    layout.quantisation_a = littleEndianAt<float>(data, 4);
    layout.quantisation_b = littleEndianAt<float>(data, 8);
  } else if (is_float) {
    layout.codec = Codec::kNone;  // no other format contains floats
  }
  return layout;
}

void describe(const sensor_msgs::CompressedImage& message, const MessageLayout& layout,
              sensor_msgs::Image& image) {
  image.header = message.header;
  image.encoding = layout.encoding;
  image.width = layout.width;
  image.height = layout.height;
  image.is_bigendian = boost::endian::order::native == boost::endian::order::big ? 1 : 0;
  const std::uint64_t step = std::uint64_t{layout.width} * (layout.encoding == enc::TYPE_32FC1 ? 4 : 2);
  image.step =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(step, std::numeric_limits<std::uint32_t>::max()));
}

// Decodes the PNG; returns an empty image unless it has the stated size and 16 bits per pixel.
cv::Mat decodePng(const sensor_msgs::CompressedImage& message, const MessageLayout& layout) {
  const cv::Mat bytes(1, static_cast<int>(message.data.size() - layout.start), CV_8UC1,
                      const_cast<std::uint8_t*>(message.data.data() + layout.start));
  cv::Mat decoded;
  try {
    decoded = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
  const bool fits = decoded.type() == CV_16UC1 && decoded.cols == static_cast<int>(layout.width) &&
                    decoded.rows == static_cast<int>(layout.height) && decoded.isContinuous();
  return fits ? decoded : cv::Mat();
}

void toMetres(const std::uint16_t* numbers, std::size_t pixels, const MessageLayout& layout,
              std::uint8_t* data) {
  for (std::size_t i = 0; i < pixels; ++i) {
    const float metres =
        numbers[i] == 0 ? std::numeric_limits<float>::quiet_NaN()
                        : layout.quantisation_a / (static_cast<float>(numbers[i]) - layout.quantisation_b);
    std::memcpy(data + i * sizeof metres, &metres, sizeof metres);
  }
}

}  // namespace

sensor_msgs::Image::Ptr describeCompressedDepth(const sensor_msgs::CompressedImage& message) {
  const MessageLayout layout = layoutOf(message);
  if (layout.codec == Codec::kNone) return {};
  auto image = boost::make_shared<sensor_msgs::Image>();
  describe(message, layout, *image);
  return image;
}

bool decodeCompressedDepth(const sensor_msgs::CompressedImage& message, std::uint64_t max_pixels,
                           sensor_msgs::Image& image) {
  const MessageLayout layout = layoutOf(message);
  if (layout.codec == Codec::kNone) return false;
  const std::uint64_t pixels = std::uint64_t{layout.width} * layout.height;
  if (pixels == 0 || pixels > max_pixels || message.data.size() > std::numeric_limits<int>::max())
    return false;
  describe(message, layout, image);

  cv::Mat png;
  std::vector<std::uint16_t> rvl;
  const std::uint16_t* numbers = nullptr;
  if (layout.codec == Codec::kPng) {
    png = decodePng(message, layout);
    if (png.empty()) return false;
    numbers = png.ptr<std::uint16_t>();
  } else {
    rvl.resize(pixels);
    if (!decodeRvl(message.data.data() + layout.start, message.data.size() - layout.start, pixels,
                   rvl.data())) {
      return false;
    }
    numbers = rvl.data();
  }
  image.data.resize(static_cast<std::size_t>(image.step) * image.height);
  if (layout.encoding == enc::TYPE_32FC1) {
    toMetres(numbers, pixels, layout, image.data.data());
  } else {
    std::memcpy(image.data.data(), numbers, pixels * sizeof *numbers);
  }
  return true;
}

std::string rawTopicOf(const std::string& compressed_topic) {
  for (const char* ending : {"/compressedDepth", "/compressed"}) {
    const std::string text = ending;
    if (compressed_topic.size() > text.size() &&
        compressed_topic.compare(compressed_topic.size() - text.size(), text.size(), text) == 0) {
      return compressed_topic.substr(0, compressed_topic.size() - text.size());
    }
  }
  return {};
}

}  // namespace line_plane_segmentation
