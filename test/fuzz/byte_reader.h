// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace line_plane_segmentation {

/// Draws values from the bytes of a fuzzer's input, in their order; zeros when they have run out.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::size_t left() const { return left_; }

  /// A number of any value, as its bytes stand there.
  template <typename T>
  T raw() {
    static_assert(std::is_arithmetic<T>::value && !std::is_same<T, bool>::value, "every pattern is a value");
    T value{};
    copy(reinterpret_cast<std::uint8_t*>(&value), sizeof value);
    return value;
  }

  /// From low to high, both included.
  int integer(int low, int high) {
    const auto span = static_cast<std::uint32_t>(high - low) + 1U;
    return low + static_cast<int>((span <= 256 ? raw<std::uint8_t>() : raw<std::uint16_t>()) % span);
  }

  /// From low to high; low where there are no bytes.
  double uniform(double low, double high) { return low + (high - low) * raw<std::uint16_t>() / 65535.0; }

  /// True in `of_256` of 256 cases; false where there are no bytes.
  bool chance(int of_256) { return raw<std::uint8_t>() > 255 - of_256; }

  /// One of those that often go wrong, or any.
  template <typename T>
  T awkward() {
    using Limits = std::numeric_limits<T>;
    if constexpr (std::is_floating_point<T>::value) {
      const std::array<T, 14> values = {T{0},
                                        Limits::quiet_NaN(),
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        Limits::min(),
                                        Limits::max(),
                                        Limits::lowest(),
                                        Limits::denorm_min(),
                                        T{-1},
                                        T{1},
                                        T{-0.0F},
                                        T{1e30F},
                                        T{1e-30F},
                                        static_cast<T>(uniform(-100.0, 100.0))};
      const auto index = static_cast<std::size_t>(integer(0, 15));
      return index < values.size() ? values[index] : raw<T>();
    } else {
      const std::array<std::uint64_t, 12> values = {
          0, 1, 2, 3, 255, 256, 65535, 65536, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
      const auto index = static_cast<std::size_t>(integer(0, 15));
      return index < values.size() ? static_cast<T>(values[index]) : raw<T>();
    }
  }

  /// Fills `size` bytes.
  void copy(std::uint8_t* to, std::size_t size) {
    const std::size_t count = std::min(size, left_);
    if (count > 0) std::memcpy(to, data_, count);
    std::fill(to + count, to + size, std::uint8_t{0});
    data_ += count;
    left_ -= count;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace line_plane_segmentation
