// SPDX-License-Identifier: BSD-3-Clause
#include "lines/scanline_set.h"

#include "lines/line_kernels.h"

namespace line_plane_segmentation {
namespace {

// Valid pixels of a row, or of every kStride-th row in a column, which is enough to compare columns.
constexpr int kStride = 5;

int validInRow(const DepthImage& depth, int v) {
  const float* z = depth.row(v);
  int valid = 0;
  for (int u = 0; u < depth.width; ++u) valid += z[u] > 0.0F ? 1 : 0;
  return valid;
}

int validInColumn(const DepthImage& depth, int u) {
  int valid = 0;
  for (int v = 0; v < depth.height; v += kStride) valid += depth.at(u, v) > 0.0F ? 1 : 0;
  return valid;
}

// Places scanlines; each may move by a pixel to where at least twice as many pixels are valid.
// @param counted  pixels that count_valid() looks at: no scanline has more
template <typename CountValid>
void place(int length, int spacing, int counted, CountValid&& count_valid, std::vector<int>& pixels) {
  pixels.clear();
  for (int at = spacing / 2; at < length; at += spacing) {
    int best = at, most = 2 * count_valid(at);
    for (const int other : {at - 1, at + 1}) {
      if (spacing < 3 || other < 0 || other >= length || most >= counted) continue;
      const int valid = count_valid(other);
      if (valid > most) best = other, most = valid;
    }
    pixels.push_back(best);
  }
}

void prepare(int length, int window, ScanlineSet& set) {
  set.window = window;
  set.windows = (length + window - 1) / window;
  set.sums.resize(static_cast<std::size_t>(set.count()) * static_cast<std::size_t>(set.windows));
}

}  // namespace

// Sums the windows in z_ and t_ into sum_lanes_.
void WindowSummer::addWindows(int pixels, int lanes) {
  const std::size_t count = static_cast<std::size_t>(lanes);
  sum_lanes_.resize(6 * count);
  double* s = sum_lanes_.data();
  sumWindows(z_.data(), t_.data(), pixels, lanes,
             {s, s + count, s + 2 * count, s + 3 * count, s + 4 * count, s + 5 * count});
}

void WindowSummer::sumRows(const DepthImage& depth, const ViewRays& rays, ScanlineSet& rows) {
  const std::size_t lanes = static_cast<std::size_t>(rows.windows),
                    window = static_cast<std::size_t>(rows.window);
  z_.resize(lanes * window);
  t_.assign(lanes * window, 0.0F);
  const std::size_t width = static_cast<std::size_t>(depth.width);
  const auto transpose = [&](const float* row, std::vector<float>& to) {
    for (std::size_t k = 0; k < window; ++k) {
      float* out = to.data() + k * lanes;
      const std::size_t inside = k < width ? (width - k + window - 1) / window : 0;
      for (std::size_t i = 0; i < inside; ++i) out[i] = row[i * window + k];
      for (std::size_t i = inside; i < lanes; ++i) out[i] = 0.0F;
    }
  };
  transpose(rays.x.data(), t_);
  for (int r = 0; r < rows.count(); ++r) {
    transpose(depth.row(rows.pixels[r]), z_);
    addWindows(rows.window, rows.windows);
    LineSums* sums = rows.sums.data() + rows.indexOf(r, 0);
    const double* s = sum_lanes_.data();
    for (std::size_t i = 0; i < lanes; ++i)
      sums[i] = {s[i], s[lanes + i], s[2 * lanes + i], s[3 * lanes + i], s[4 * lanes + i], s[5 * lanes + i]};
  }
}

void WindowSummer::sumColumns(const DepthImage& depth, const ViewRays& rays, ScanlineSet& columns) {
  const std::size_t lanes = columns.pixels.size(), window = static_cast<std::size_t>(columns.window);
  z_.resize(lanes * window);
  t_.resize(lanes * window);
  for (int w = 0; w < columns.windows; ++w) {
    const int first = w * columns.window, count = std::min(columns.window, depth.height - first);
    float *z = z_.data(), *t = t_.data();
    for (int v = first; v < first + count; ++v) {
      const float* row = depth.row(v);
#pragma GCC unroll 4
      for (const int u : columns.pixels) *z++ = row[u];
      t = std::fill_n(t, lanes, rays.y[v]);
    }
    addWindows(count, static_cast<int>(lanes));
    const double* s = sum_lanes_.data();
    for (std::size_t i = 0; i < lanes; ++i)
      columns.sums[columns.indexOf(static_cast<int>(i), w)] = {
          s[i], s[lanes + i], s[2 * lanes + i], s[3 * lanes + i], s[4 * lanes + i], s[5 * lanes + i]};
  }
}

void WindowSummer::sum(const DepthImage& depth, const ViewRays& rays, int spacing, int window,
                       ScanlineSet& rows, ScanlineSet& columns) {
  rows.direction = ScanDirection::kRow;
  columns.direction = ScanDirection::kColumn;
  place(
      depth.height, spacing, depth.width, [&](int v) { return validInRow(depth, v); }, rows.pixels);
  place(
      depth.width, spacing, (depth.height + kStride - 1) / kStride,
      [&](int u) { return validInColumn(depth, u); }, columns.pixels);
  prepare(depth.width, window, rows);
  prepare(depth.height, window, columns);
  sumRows(depth, rays, rows);
  sumColumns(depth, rays, columns);
}

}  // namespace line_plane_segmentation
