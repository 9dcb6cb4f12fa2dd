// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// How one depth pixel is stored.
enum class DepthType : std::uint8_t {
  kUint16,   ///< unsigned 16-bit, 0 = no depth (ROS 16UC1 and mono16)
  kFloat32,  ///< IEEE float, anything but a finite number from a micrometre on = no depth (ROS 32FC1)
};

/// Size of one pixel [bytes].
constexpr std::size_t bytesPerPixel(DepthType type) { return type == DepthType::kUint16 ? 2 : 4; }

/// A non-owning view of a depth image: depth along the optical axis, row by row, in memory that
/// somebody else keeps alive. Rows may be padded and pixels need not be aligned.
///
/// Whoever makes a view promises that `data` holds `(height - 1) * step + width * bytesPerPixel(type)`
/// bytes; on the ROS side validate() is the one place that does.
struct DepthView {
  const std::uint8_t* data = nullptr;
  int width = 0;         ///< [px]
  int height = 0;        ///< [px]
  std::size_t step = 0;  ///< [bytes] from one row to the next
  DepthType type = DepthType::kUint16;
  union {
    float depth_unit = 0.001F;  ///< [m] depth of one count of the stored number, positive
    float metres_per_unit;      ///< older name of depth_unit
  };
  bool swap_bytes = false;  ///< stored in the other byte order than this machine's

  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
};

/// A view of a tightly packed 16-bit image.
DepthView viewOf(const std::uint16_t* pixels, int width, int height, float depth_unit = 0.001F);

/// A view of a tightly packed float image.
DepthView viewOf(const float* pixels, int width, int height, float depth_unit = 1.0F);

/// Depths outside (min, max) count as missing, and whatever is nearer than a micrometre.
struct DepthRange {
  float min = 0.0F;    ///< [m]
  float max = 1.0e3F;  ///< [m]
};

/// Reads `width` pixels of row `v` as metres into `depth`, 0 where there is no depth within `range`:
/// the one place that knows how pixels are stored. Every number written is finite and not negative.
/// @return how many of them have a depth
int loadRow(const DepthView& view, int v, const DepthRange& range, float* depth);

/// As loadRow(), for the `height` pixels of column `u`.
int loadColumn(const DepthView& view, int u, const DepthRange& range, float* depth);

}  // namespace line_plane_segmentation
