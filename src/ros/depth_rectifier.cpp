// SPDX-License-Identifier: BSD-3-Clause
#include "depth_rectifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image_validation.h"
#include "lens_distortion.h"

namespace line_plane_segmentation {
namespace {

constexpr double kWidestSlope = 3.0;  // 72 degrees off the axis; farther out, pixels are stretched too much
constexpr float kNearest = 1e-6F;     // [m]; smaller depths are invalid, their inverse could overflow

bool isSameCalibration(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  return a.distortion_model == b.distortion_model && a.D == b.D && a.K == b.K && a.P == b.P &&
         a.binning_x == b.binning_x && a.binning_y == b.binning_y && a.roi.x_offset == b.roi.x_offset &&
         a.roi.y_offset == b.roi.y_offset && a.roi.width == b.roi.width && a.roi.height == b.roi.height;
}

bool differ(const CameraIntrinsics& a, const CameraIntrinsics& b) {
  constexpr double kSame = 1e-3;  // [px]
  return std::max({std::abs(a.fx - b.fx), std::abs(a.fy - b.fy), std::abs(a.cx - b.cx),
                   std::abs(a.cy - b.cy)}) > kSame;
}

// Returns the slope of the ray to a pixel on an axis, by bisection: along the axis, pixel coordinates
// increase with the slope.
double slopeAt(const LensDistortion& lens, const CameraIntrinsics& camera, bool along_x, double pixel,
               double limit) {
  const double centre = along_x ? camera.cx : camera.cy;
  const double sign = pixel < centre ? -1.0 : 1.0;
  double low = 0.0;
  double high = limit;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    const double slope = sign * middle;
    const cv::Point2d seen =
        lens.project({along_x ? cv::Point2d(slope, 0.0) : cv::Point2d(0.0, slope)}, camera).front();
    const double reached = sign * ((along_x ? seen.x : seen.y) - centre);
    (reached < sign * (pixel - centre) ? low : high) = middle;
  }
  return sign * low;
}

// Returns a camera with the same field of view along both axes as the raw image.
CameraIntrinsics fullViewCamera(const LensDistortion& lens, const CameraIntrinsics& raw, int width,
                                int height, double limit) {
  const double left = slopeAt(lens, raw, true, 0.0, limit);
  const double right = slopeAt(lens, raw, true, width - 1.0, limit);
  const double top = slopeAt(lens, raw, false, 0.0, limit);
  const double bottom = slopeAt(lens, raw, false, height - 1.0, limit);
  CameraIntrinsics camera;
  camera.fx = (width - 1.0) / (right - left);
  camera.fy = (height - 1.0) / (bottom - top);
  camera.cx = -left * camera.fx;
  camera.cy = -top * camera.fy;
  return camera;
}

// The "minmod" limiter: the slope of smaller magnitude, 0 if the signs differ. Exact on a plane, where both
// are equal; beside a depth step, the slope of the pixel's own surface.
float minmod(float a, float b) {
  if (a * b <= 0.0F) return 0.0F;
  return std::abs(a) < std::abs(b) ? a : b;
}

}  // namespace

bool DepthRectifier::setCamera(const sensor_msgs::CameraInfo& info, int width, int height) {
  if (info_ && width == width_ && height == height_ && isSameCalibration(*info_, info)) return is_valid_;
  info_ = info;
  width_ = width;
  height_ = height;
  is_valid_ = computeTables(info, width, height);
  return is_valid_;
}

bool DepthRectifier::computeTables(const sensor_msgs::CameraInfo& info, int width, int height) {
  const CameraIntrinsics raw = rawIntrinsics(info);
  const std::optional<LensDistortion> lens = LensDistortion::fromCameraInfo(info);
  if (!lens || !isUsable(raw) || width < 2 || height < 2) return false;
  const double largest = lens->maxMonotonicRadius(raw);
  if (!(largest > 0.0)) return false;
  const CameraIntrinsics projection = rectifiedIntrinsics(info);
  const bool is_given = isUsable(projection) && differ(projection, raw);
  camera_ =
      is_given ? projection : fullViewCamera(*lens, raw, width, height, std::min(largest, kWidestSlope));
  if (!isUsable(camera_)) return false;

  source_pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {-1, 0, 0});
  std::vector<cv::Point2d> row(static_cast<std::size_t>(width));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      row[u] = {(u - camera_.cx) / camera_.fx, (v - camera_.cy) / camera_.fy};
    }
    const std::vector<cv::Point2d> pixels = lens->project(row, raw);
    for (int u = 0; u < width; ++u) {
      const cv::Point2d& ray = row[u];
      const cv::Point2d& pixel = pixels[u];
      if (std::hypot(ray.x, ray.y) > largest) continue;
      // Negated, so that NaN is outside.
      if (!(pixel.x >= 0.0 && pixel.x <= width - 1.0 && pixel.y >= 0.0 && pixel.y <= height - 1.0)) continue;
      const int left = std::min(static_cast<int>(pixel.x), width - 2);
      const int top = std::min(static_cast<int>(pixel.y), height - 2);
      source_pixels_[v * width + u] = {top * width + left,
                                       static_cast<std::uint8_t>(255.0 * (pixel.x - left)),
                                       static_cast<std::uint8_t>(255.0 * (pixel.y - top))};
    }
  }
  return true;
}

DepthView DepthRectifier::rectify(const DepthView& raw) {
  constexpr DepthRange kAny{0.0F, std::numeric_limits<float>::max()};
  const auto width = static_cast<std::size_t>(width_);
  inverse_depth_.resize(source_pixels_.size());
  rectified_.resize(source_pixels_.size());
  for (int v = 0; v < height_; ++v) {
    float* const row = inverse_depth_.data() + static_cast<std::size_t>(v) * width;
    loadRow(raw, v, kAny, row);
    for (std::size_t u = 0; u < width; ++u) row[u] = row[u] > kNearest ? 1.0F / row[u] : 0.0F;
  }
  for (std::size_t i = 0; i < source_pixels_.size(); ++i) {
    const float inverse = source_pixels_[i].index < 0 ? 0.0F : interpolate(source_pixels_[i]);
    rectified_[i] = inverse > 0.0F ? 1.0F / inverse : 0.0F;
  }
  return viewOf(rectified_.data(), width_, height_);
}

float DepthRectifier::interpolate(const SourcePixel& source) const {
  constexpr float kSmooth = 1.05F;  // ratio; four pixels that differ by more can be of two surfaces
  constexpr float kUnit = 1.0F / 255.0F;
  const auto width = static_cast<std::size_t>(width_);
  const float* const at = inverse_depth_.data() + source.index;
  const float a = at[0], b = at[1], c = at[width], d = at[width + 1];
  const float right = kUnit * source.right;
  const float down = kUnit * source.down;
  const float least = std::min(std::min(a, b), std::min(c, d));
  const float largest = std::max(std::max(a, b), std::max(c, d));
  if (largest <= kSmooth * least) {
    const float upper = a + right * (b - a);
    const float lower = c + right * (d - c);
    return upper + down * (lower - upper);
  }
  // Extrapolates the surface of the nearest pixel, with a slope that does not reach across a depth step.
  const bool is_right = source.right >= 128;
  const bool is_lower = source.down >= 128;
  const int u = source.index % width_ + (is_right ? 1 : 0);
  const int v = source.index / width_ + (is_lower ? 1 : 0);
  const float nearest = inverseDepthAt(u, v);
  if (nearest == 0.0F) return 0.0F;
  const float extrapolated = nearest + (is_right ? right - 1.0F : right) * limitedSlope(u, v, 1, 0) +
                             (is_lower ? down - 1.0F : down) * limitedSlope(u, v, 0, 1);
  return extrapolated > 0.0F ? extrapolated : nearest;
}

float DepthRectifier::inverseDepthAt(int u, int v) const {
  const bool is_inside = u >= 0 && u < width_ && v >= 0 && v < height_;
  return is_inside ? inverse_depth_[v * width_ + u] : 0.0F;
}

float DepthRectifier::limitedSlope(int u, int v, int du, int dv) const {
  const float centre = inverseDepthAt(u, v);
  const float before = inverseDepthAt(u - du, v - dv);
  const float after = inverseDepthAt(u + du, v + dv);
  if (before > 0.0F && after > 0.0F) return minmod(centre - before, after - centre);
  // With one neighbour only, the pixel beyond it has to continue the slope.
  if (after > 0.0F) {
    const float beyond = inverseDepthAt(u + 2 * du, v + 2 * dv);
    return beyond > 0.0F ? minmod(after - centre, beyond - after) : 0.0F;
  }
  const float beyond = inverseDepthAt(u - 2 * du, v - 2 * dv);
  return before > 0.0F && beyond > 0.0F ? minmod(centre - before, before - beyond) : 0.0F;
}

}  // namespace line_plane_segmentation
