// SPDX-License-Identifier: BSD-3-Clause
#include "image_header.h"

#include <cstdio>
#include <cstring>
#include <string>

namespace line_plane_segmentation {
namespace {

using Bytes = std::vector<unsigned char>;

bool beginsWith(const Bytes& bytes, const std::string& text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

// An unsigned number of `size` bytes; 0 beyond the end.
std::uint32_t numberAt(const Bytes& bytes, std::size_t at, std::size_t size, bool big_endian) {
  if (at > bytes.size() || bytes.size() - at < size) return 0;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number = number << 8U | bytes[at + (big_endian ? i : size - 1 - i)];
  }
  return number;
}

std::optional<ImageHeader> readPng(const Bytes& bytes) {
  constexpr std::size_t kHeaderEnd = 33;
  if (bytes.size() < kHeaderEnd || std::memcmp(bytes.data() + 12, "IHDR", 4) != 0) return std::nullopt;
  constexpr int kChannels[] = {1, 0, 3, 3, 2, 0, 4};  // by colour type; a palette becomes 3
  const unsigned color_type = bytes[25];
  return ImageHeader{numberAt(bytes, 16, 4, true), numberAt(bytes, 20, 4, true), bytes[24],
                     color_type < 7 ? kChannels[color_type] : 0};
}

// The first directory of the file; other directories are not read by OpenCV's imdecode().
std::optional<ImageHeader> readTiff(const Bytes& bytes) {
  constexpr std::uint32_t kWidth = 256, kHeight = 257, kShort = 3, kEntryBytes = 12;
  const bool big_endian = bytes[0] == 'M';
  const std::size_t directory = numberAt(bytes, 4, 4, big_endian);
  const std::uint32_t entries = numberAt(bytes, directory, 2, big_endian);
  ImageHeader header;
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + std::size_t{kEntryBytes} * i;
    const std::uint32_t tag = numberAt(bytes, entry, 2, big_endian);
    const std::size_t size = numberAt(bytes, entry + 2, 2, big_endian) == kShort ? 2 : 4;
    if (tag == kWidth) header.width = numberAt(bytes, entry + 8, size, big_endian);
    if (tag == kHeight) header.height = numberAt(bytes, entry + 8, size, big_endian);
  }
  if (header.width == 0 || header.height == 0) return std::nullopt;
  return header;
}

// Attributes: name, 0, type, 0, length, value. The box dataWindow has the first and last column and row.
std::optional<ImageHeader> readExr(const Bytes& bytes) {
  std::size_t at = 8;
  const auto take_text = [&] {
    const std::size_t begin = at;
    while (at < bytes.size() && bytes[at] != 0) ++at;
    return std::string(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                       bytes.begin() + static_cast<std::ptrdiff_t>(at++));
  };
  while (at < bytes.size()) {
    const std::string name = take_text();
    if (name.empty() || at >= bytes.size()) break;
    take_text();
    if (at + 4 > bytes.size()) break;
    const std::size_t length = numberAt(bytes, at, 4, false);
    at += 4;
    if (name == "dataWindow" && length == 16 && at + length <= bytes.size()) {
      const auto edge = [&](std::size_t i) {
        return std::int64_t{static_cast<std::int32_t>(numberAt(bytes, at + 4 * i, 4, false))};
      };
      return ImageHeader{edge(2) - edge(0) + 1, edge(3) - edge(1) + 1, 0, 0};
    }
    at += length;
  }
  return std::nullopt;
}

std::optional<ImageHeader> readPgm(const Bytes& bytes) {
  const std::string text(
      bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 200)));
  long long width = 0, height = 0;
  if (std::sscanf(text.c_str(), "P5 %lld %lld", &width, &height) != 2) return std::nullopt;
  return ImageHeader{width, height, 0, 1};
}

}  // namespace

bool isPng(const Bytes& bytes) { return beginsWith(bytes, "\x89PNG\r\n\x1a\n"); }

std::optional<ImageHeader> readImageHeader(const Bytes& bytes) {
  if (isPng(bytes)) return readPng(bytes);
  if (beginsWith(bytes, std::string("II*\0", 4)) || beginsWith(bytes, std::string("MM\0*", 4)))
    return readTiff(bytes);
  if (beginsWith(bytes, "\x76\x2f\x31\x01")) return readExr(bytes);
  if (beginsWith(bytes, "P5")) return readPgm(bytes);
  return std::nullopt;
}

}  // namespace line_plane_segmentation
