// SPDX-License-Identifier: BSD-3-Clause
#include "npy_file.h"

#include <cstring>
#include <regex>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

constexpr char kMagic[] = "\x93NUMPY";
constexpr std::size_t kMagicLength = 6;

struct NpyHeader {
  std::string text;  // a Python dictionary
  std::size_t end = 0;
};

NpyHeader headerOf(const std::vector<unsigned char>& bytes, const std::string& name) {
  const std::size_t length_bytes = bytes.size() > kMagicLength && bytes[kMagicLength] >= 2 ? 4 : 2;
  const std::size_t begin = kMagicLength + 2 + length_bytes;
  std::size_t length = 0;
  for (std::size_t i = 0; i < length_bytes && begin <= bytes.size(); ++i) {
    length |= std::size_t{bytes[kMagicLength + 2 + i]} << (8 * i);
  }
  if (begin > bytes.size() || length > bytes.size() - begin)
    throw BadInput(name + ": is cut off in its header");
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
  return {std::string(first, first + static_cast<std::ptrdiff_t>(length)), begin + length};
}

std::string match(const std::string& text, const char* pattern) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "";
}

int typeOf(const std::string& description, const std::string& name) {
  if (description == "<u2") return CV_16UC1;
  if (description == "<f4") return CV_32FC1;
  if (description == "<f8") return CV_64FC1;
  throw BadInput(name + ": holds numbers of type '" + description + "', not uint16, float32 or float64");
}

// 0 if it is not a number of a reasonable size.
std::int64_t lengthOf(const std::string& digits) {
  constexpr std::size_t kMostDigits = 9;
  return digits.empty() || digits.size() > kMostDigits ? 0 : std::stoll(digits);
}

}  // namespace

bool isNpy(const std::vector<unsigned char>& bytes) {
  return bytes.size() >= kMagicLength && std::memcmp(bytes.data(), kMagic, kMagicLength) == 0;
}

cv::Mat decodeNpy(const std::vector<unsigned char>& bytes, const std::string& name, std::int64_t max_pixels) {
  const NpyHeader header = headerOf(bytes, name);
  const int type = typeOf(match(header.text, R"('descr'\s*:\s*'([^']*)')"), name);
  const std::int64_t rows = lengthOf(match(header.text, R"('shape'\s*:\s*\(\s*(\d+)\s*,\s*\d+\s*,?\s*\))"));
  const std::int64_t columns =
      lengthOf(match(header.text, R"('shape'\s*:\s*\(\s*\d+\s*,\s*(\d+)\s*,?\s*\))"));
  if (rows == 0 || columns == 0) throw BadInput(name + ": is not an array of rows and columns");
  if (match(header.text, R"('fortran_order'\s*:\s*(False))").empty()) {
    throw BadInput(name + ": is in Fortran order; save numpy.ascontiguousarray(depth)");
  }
  if (rows * columns > max_pixels) {
    throw BadInput(name + ": has " + std::to_string(columns) + " x " + std::to_string(rows) +
                   " pixels, too many; see --max-pixels");
  }
  cv::Mat image(static_cast<int>(rows), static_cast<int>(columns), type);
  const std::size_t size = image.total() * image.elemSize();
  if (bytes.size() - header.end < size) throw BadInput(name + ": is cut off");
  std::memcpy(image.data, bytes.data() + header.end, size);
  return image;
}

}  // namespace line_plane_segmentation
