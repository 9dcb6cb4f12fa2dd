// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/depth_view.h"

#include <cstring>

#include "kernels/multiversion.h"

namespace line_plane_segmentation {
namespace {

template <typename Unsigned>
Unsigned swapBytes(Unsigned value) {
  Unsigned swapped = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    swapped = static_cast<Unsigned>((swapped << 8) | (value & 0xFF));
    value = static_cast<Unsigned>(value >> 8);
  }
  return swapped;
}

// Not every float is a depth: NaN fails both comparisons, and so becomes 0 like whatever is out of range.
inline float depthInRange(float z, const DepthRange& range) {
  return z > range.min && z < range.max ? z : 0.0F;
}

// Pixels may lie at any address, so they are loaded with memcpy, which compiles to a plain load.
template <typename Stored, typename Bits, bool kSwap>
int load(const std::uint8_t* first, std::size_t stride, int count, float scale, const DepthRange& range,
         float* depth) {
  int depths = 0;
  for (int i = 0; i < count; ++i) {
    Bits bits;
    std::memcpy(&bits, first + static_cast<std::size_t>(i) * stride, sizeof bits);
    if (kSwap) bits = swapBytes(bits);
    Stored stored;
    std::memcpy(&stored, &bits, sizeof stored);
    depth[i] = depthInRange(static_cast<float>(stored) * scale, range);
    depths += depth[i] > 0.0F ? 1 : 0;
  }
  return depths;
}

// The usual case, a row of 16-bit pixels in this machine's byte order, for which no time is to be lost.
LPS_MULTIVERSION
int loadPackedUint16(const std::uint8_t* __restrict first, int count, float scale, const DepthRange& range,
                     float* __restrict depth) {
  const DepthRange bounds = range;
  int depths = 0;
  for (int i = 0; i < count; ++i) {
    std::uint16_t stored;
    std::memcpy(&stored, first + 2 * static_cast<std::size_t>(i), sizeof stored);
    const float z = depthInRange(static_cast<float>(stored) * scale, bounds);
    depth[i] = z;
    depths += z > 0.0F ? 1 : 0;
  }
  return depths;
}

int load(const DepthView& view, const std::uint8_t* first, std::size_t stride, int count, DepthRange range,
         float* depth) {
  const float scale = view.depth_unit;
  // No camera sees what is nearer than a micrometre, and of such numbers the powers that a plane's covariance
  // is made of are 0. A NaN bound is none.
  constexpr float kSmallest = 1e-6F;  // [m]
  if (!(range.min >= kSmallest)) range.min = kSmallest;
  if (view.type == DepthType::kUint16) {
    if (view.swap_bytes)
      return load<std::uint16_t, std::uint16_t, true>(first, stride, count, scale, range, depth);
    if (stride == 2) return loadPackedUint16(first, count, scale, range, depth);
    return load<std::uint16_t, std::uint16_t, false>(first, stride, count, scale, range, depth);
  }
  if (view.swap_bytes) return load<float, std::uint32_t, true>(first, stride, count, scale, range, depth);
  if (stride == 4) return load<float, std::uint32_t, false>(first, 4, count, scale, range, depth);
  return load<float, std::uint32_t, false>(first, stride, count, scale, range, depth);
}

template <typename Pixel>
DepthView viewOfPacked(const Pixel* pixels, int width, int height, DepthType type, float depth_unit) {
  DepthView view;
  view.data = reinterpret_cast<const std::uint8_t*>(pixels);
  view.width = width;
  view.height = height;
  view.step = static_cast<std::size_t>(width) * sizeof(Pixel);
  view.type = type;
  view.depth_unit = depth_unit;
  return view;
}

}  // namespace

DepthView viewOf(const std::uint16_t* pixels, int width, int height, float depth_unit) {
  return viewOfPacked(pixels, width, height, DepthType::kUint16, depth_unit);
}

DepthView viewOf(const float* pixels, int width, int height, float depth_unit) {
  return viewOfPacked(pixels, width, height, DepthType::kFloat32, depth_unit);
}

int loadRow(const DepthView& view, int v, const DepthRange& range, float* depth) {
  return load(view, view.data + static_cast<std::size_t>(v) * view.step, bytesPerPixel(view.type), view.width,
              range, depth);
}

int loadColumn(const DepthView& view, int u, const DepthRange& range, float* depth) {
  return load(view, view.data + static_cast<std::size_t>(u) * bytesPerPixel(view.type), view.step,
              view.height, range, depth);
}

}  // namespace line_plane_segmentation
