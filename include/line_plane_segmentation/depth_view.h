// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace line_plane_segmentation {

/// Storage format of a depth pixel.
enum class DepthType : std::uint8_t {
  kUint16,   ///< unsigned 16-bit, 0 = invalid depth (ROS 16UC1 and mono16)
  kFloat32,  ///< IEEE float; NaN, infinity and numbers below 1 µm = invalid depth (ROS 32FC1)
};

/// Returns the size of one pixel [bytes].
constexpr std::size_t bytesPerPixel(DepthType type) { return type == DepthType::kUint16 ? 2 : 4; }

/// Non-owning view of a depth image: depth along the optical axis, row by row. Rows may be padded and pixels
/// need not be aligned.
///
/// @pre `data` holds `(height - 1) * step + width * bytesPerPixel(type)` bytes, which stay allocated while
/// the view is used. For ROS messages, validate() checks this.
struct DepthView {
  const std::uint8_t* data = nullptr;
  int width = 0;         ///< [px]
  int height = 0;        ///< [px]
  std::size_t step = 0;  ///< [bytes] from one row to the next
  DepthType type = DepthType::kUint16;
  union {
    float depth_unit = 0.001F;  ///< [m] depth of one count of the stored number, positive
    float metres_per_unit;      ///< older name of depth_unit; not for constant expressions
  };
  bool swap_bytes = false;  ///< true if the byte order differs from the host's

  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
};

/// Returns a view of a 16-bit image without row padding.
DepthView viewOf(const std::uint16_t* pixels, int width, int height, float depth_unit = 0.001F);

/// Returns a view of a float image without row padding.
DepthView viewOf(const float* pixels, int width, int height, float depth_unit = 1.0F);

/// Range of valid depths: greater than `min`, less than `max`, and at least 1 µm.
struct DepthRange {
  float min = 0.0F;    ///< [m]
  float max = 1.0e3F;  ///< [m]
};

/// Reads the `width` pixels of row `v` into `depth` [m]. Depths that are invalid or outside of `range` are
/// written as 0, so all values are finite and not negative. Only this function and loadColumn() depend on the
/// storage format.
/// @return number of valid depths
int loadRow(const DepthView& view, int v, const DepthRange& range, float* depth);

/// Same as loadRow() for the `height` pixels of column `u`.
int loadColumn(const DepthView& view, int u, const DepthRange& range, float* depth);

}  // namespace line_plane_segmentation
