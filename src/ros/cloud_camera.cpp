// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <cstring>

#include "cloud_validation.h"

namespace line_plane_segmentation {
namespace {

float floatAt(const std::uint8_t* bytes, bool swap) {
  std::uint32_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  if (swap) bits = boost::endian::endian_reverse(bits);
  float number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

// Least-squares fit of slope = (pixel - c) / f.
class AxisFit {
 public:
  void add(double pixel, double slope) {
    n_ += 1.0;
    p_ += pixel;
    s_ += slope;
    pp_ += pixel * pixel;
    ps_ += pixel * slope;
    ss_ += slope * slope;
  }

  // Returns false if all pixels are equal, or the slope does not increase with them.
  bool solve(double& f, double& c, double& squared_error) const {
    const double spread = n_ * pp_ - p_ * p_;
    const double common = n_ * ps_ - p_ * s_;
    if (!(spread > 0.0) || !(common > 0.0)) return false;
    f = spread / common;
    c = (p_ - f * s_) / n_;
    squared_error = std::max(0.0, f * f * (n_ * ss_ - s_ * s_ - common / f) / (n_ * n_));
    return true;
  }

  bool isFlat() const { return !(n_ * pp_ - p_ * p_ > 0.0); }

 private:
  double n_ = 0.0, p_ = 0.0, s_ = 0.0, pp_ = 0.0, ps_ = 0.0, ss_ = 0.0;
};

// Fits of both axes to a sample of the points.
struct CameraFit {
  AxisFit columns;
  AxisFit rows;
  long in_front = 0;  // number of points with positive z
  long behind = 0;    // number of points with negative z
};

CameraFit fitAxes(const CloudView& cloud) {
  constexpr double kSamples = 10000.0;
  constexpr double kFarthestSlope = 100.0;
  CameraFit fit;
  const double points = static_cast<double>(cloud.width) * cloud.height;
  const int step = std::max(1, static_cast<int>(std::sqrt(points / kSamples)));
  for (int v = step / 2; v < cloud.height; v += step) {
    const std::uint8_t* row = cloud.data + static_cast<std::size_t>(v) * cloud.row_step;
    for (int u = step / 2; u < cloud.width; u += step) {
      const std::uint8_t* point = row + static_cast<std::size_t>(u) * cloud.point_step;
      const double x = floatAt(point + cloud.x, cloud.swap_bytes);
      const double y = floatAt(point + cloud.y, cloud.swap_bytes);
      const float z = floatAt(point + cloud.z, cloud.swap_bytes);
      const double farthest = kFarthestSlope * std::abs(z);
      if (!std::isnormal(z) || !(std::abs(x) < farthest && std::abs(y) < farthest)) continue;
      ++(z > 0.0F ? fit.in_front : fit.behind);
      if (z < 0.0F) continue;
      fit.columns.add(u, x / static_cast<double>(z));
      fit.rows.add(v, y / static_cast<double>(z));
    }
  }

  return fit;
}

}  // namespace

CloudCamera cameraOf(const CloudView& cloud) {
  const auto [columns, rows, in_front, behind] = fitAxes(cloud);
  CloudCamera found;
  if (behind > in_front) {
    found.refusal = Refusal::kNotPinhole;
    return found;
  }
  if (columns.isFlat() || rows.isFlat()) {
    const double f = cloud.width;
    found.camera = {f, f, (cloud.width - 1) / 2.0, (cloud.height - 1) / 2.0};
    return found;
  }
  constexpr double kMostDeviation = 0.01;  // fraction of the width; lens distortion is well below
  double column_error = 0.0;
  double row_error = 0.0;
  CameraIntrinsics& camera = found.camera;
  const bool solved =
      columns.solve(camera.fx, camera.cx, column_error) && rows.solve(camera.fy, camera.cy, row_error);
  found.deviation = std::sqrt(column_error + row_error);
  if (!solved || !isUsable(camera) || !(found.deviation <= std::max(1.0, kMostDeviation * cloud.width))) {
    found.refusal = Refusal::kNotPinhole;
  }
  return found;
}

}  // namespace line_plane_segmentation
