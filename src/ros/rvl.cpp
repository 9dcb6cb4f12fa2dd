// SPDX-License-Identifier: BSD-3-Clause
#include "rvl.h"

#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <cstring>

namespace line_plane_segmentation {
namespace {

// Numbers of variable length: three bits in each nibble, whose highest bit says that more follow. A word
// holds eight nibbles, the first in its highest bits.
class NibbleReader {
 public:
  NibbleReader(const std::uint8_t* data, std::size_t size)
      : data_(data), words_(size / sizeof(std::uint32_t)) {}

  bool next(std::uint32_t& value) {
    value = 0;
    for (unsigned shift = 0; shift < 32; shift += 3) {
      if (left_ == 0 && !loadWord()) return false;
      const std::uint32_t nibble = word_ >> 28U;
      word_ <<= 4U;
      --left_;
      value |= (nibble & 7U) << shift;
      if ((nibble & 8U) == 0) return true;
    }
    return false;
  }

 private:
  bool loadWord() {
    if (words_ == 0) return false;
    std::memcpy(&word_, data_, sizeof word_);
    word_ = boost::endian::little_to_native(word_);
    data_ += sizeof word_;
    --words_;
    left_ = 8;
    return true;
  }

  const std::uint8_t* data_;
  std::size_t words_;
  std::uint32_t word_ = 0;
  unsigned left_ = 0;
};

}  // namespace

bool decodeRvl(const std::uint8_t* data, std::size_t size, std::size_t pixels, std::uint16_t* depth) {
  std::fill_n(depth, pixels, std::uint16_t{0});
  NibbleReader nibbles(data, size);
  std::uint32_t previous = 0;
  for (std::size_t i = 0; i < pixels;) {
    std::uint32_t zeros = 0;
    std::uint32_t depths = 0;
    if (!nibbles.next(zeros) || zeros > pixels - i) return false;
    i += zeros;
    if (!nibbles.next(depths) || depths > pixels - i) return false;
    if (zeros == 0 && depths == 0) return false;
    for (const std::size_t end = i + depths; i < end; ++i) {
      std::uint32_t change = 0;
      if (!nibbles.next(change)) return false;
      // The sign is the lowest bit.
      previous += (change >> 1U) ^ (0U - (change & 1U));
      depth[i] = static_cast<std::uint16_t>(previous);
    }
  }
  return true;
}

}  // namespace line_plane_segmentation
