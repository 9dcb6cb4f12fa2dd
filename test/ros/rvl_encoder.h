// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation {

/// Encodes depth as RVL, after the listing in Wilson's paper: what decodeRvl() is tested against.
class RvlEncoder {
 public:
  static std::vector<std::uint8_t> encode(const std::vector<std::uint16_t>& depth) {
    RvlEncoder encoder;
    int previous = 0;
    for (std::size_t i = 0; i < depth.size();) {
      std::size_t zeros = 0;
      while (i + zeros < depth.size() && depth[i + zeros] == 0) ++zeros;
      i += zeros;
      std::size_t depths = 0;
      while (i + depths < depth.size() && depth[i + depths] != 0) ++depths;
      encoder.number(static_cast<std::uint32_t>(zeros));
      encoder.number(static_cast<std::uint32_t>(depths));
      for (const std::size_t end = i + depths; i < end; ++i) {
        const int change = depth[i] - previous;
        encoder.number(static_cast<std::uint32_t>((change << 1) ^ (change >> 31)));
        previous = depth[i];
      }
    }
    while (encoder.nibbles_ != 0) encoder.nibble(0);
    return encoder.bytes_;
  }

 private:
  void number(std::uint32_t value) {
    do {
      const std::uint32_t low = value & 7U;
      value >>= 3U;
      nibble(low | (value != 0 ? 8U : 0U));
    } while (value != 0);
  }

  void nibble(std::uint32_t value) {
    word_ = word_ << 4U | value;
    if (++nibbles_ < 8) return;
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(word_ >> shift));
    nibbles_ = 0;
  }

  std::vector<std::uint8_t> bytes_;
  std::uint32_t word_ = 0;
  int nibbles_ = 0;
};

}  // namespace line_plane_segmentation
