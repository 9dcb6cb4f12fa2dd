// SPDX-License-Identifier: BSD-3-Clause
#include "depth_rectifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lens_distortion.h"
#include "line_plane_segmentation/ros/image_validation.h"

namespace line_plane_segmentation {
namespace {

constexpr double kWidestSlope =
    3.0;  // 72 degrees off the axis; beyond, pixels would be stretched out of shape

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

// The slope along an axis at which the lens sees a pixel of it, by bisection: along the axis pixels grow with
// slopes.
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

// A camera whose image of this size ends where the raw image does, on both of its axes.
CameraIntrinsics wholeView(const LensDistortion& lens, const CameraIntrinsics& raw, int width, int height,
                           double limit) {
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

}  // namespace

bool DepthRectifier::setCamera(const sensor_msgs::CameraInfo& info, int width, int height) {
  if (info_ && width == width_ && height == height_ && isSameCalibration(*info_, info)) return is_known_;
  info_ = info;
  width_ = width;
  height_ = height;
  is_known_ = compute(info, width, height);
  return is_known_;
}

bool DepthRectifier::compute(const sensor_msgs::CameraInfo& info, int width, int height) {
  const CameraIntrinsics raw = rawIntrinsics(info);
  const std::optional<LensDistortion> lens = LensDistortion::of(info);
  if (!lens || !isUsable(raw) || width < 2 || height < 2) return false;
  const double largest = lens->largestRadius(raw);
  if (!(largest > 0.0)) return false;
  const CameraIntrinsics projection = rectifiedIntrinsics(info);
  const bool is_given = isUsable(projection) && differ(projection, raw);
  camera_ = is_given ? projection : wholeView(*lens, raw, width, height, std::min(largest, kWidestSlope));
  if (!isUsable(camera_)) return false;

  sources_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {-1, 0, 0});
  std::vector<cv::Point2d> row(static_cast<std::size_t>(width));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      row[static_cast<std::size_t>(u)] = {(u - camera_.cx) / camera_.fx, (v - camera_.cy) / camera_.fy};
    }
    const std::vector<cv::Point2d> pixels = lens->project(row, raw);
    for (int u = 0; u < width; ++u) {
      const cv::Point2d& ray = row[static_cast<std::size_t>(u)];
      const cv::Point2d& pixel = pixels[static_cast<std::size_t>(u)];
      if (std::hypot(ray.x, ray.y) > largest) continue;
      // Not outside, which a NaN is not.
      if (!(pixel.x >= 0.0 && pixel.x <= width - 1.0 && pixel.y >= 0.0 && pixel.y <= height - 1.0)) continue;
      const int left = std::min(static_cast<int>(pixel.x), width - 2);
      const int top = std::min(static_cast<int>(pixel.y), height - 2);
      sources_[static_cast<std::size_t>(v * width + u)] = {
          top * width + left, static_cast<std::uint8_t>(255.0 * (pixel.x - left)),
          static_cast<std::uint8_t>(255.0 * (pixel.y - top))};
    }
  }
  return true;
}

DepthView DepthRectifier::rectify(const DepthView& raw) {
  constexpr float kSmooth =
      1.05F;  // farther apart, four pixels are not of one surface: the nearest of them counts
  constexpr float kUnit = 1.0F / 255.0F;
  const DepthRange any{0.0F, std::numeric_limits<float>::max()};
  const auto width = static_cast<std::size_t>(width_);
  raw_.resize(sources_.size());
  rectified_.resize(sources_.size());
  for (int v = 0; v < height_; ++v) loadRow(raw, v, any, raw_.data() + static_cast<std::size_t>(v) * width);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source source = sources_[i];
    if (source.index < 0) {
      rectified_[i] = 0.0F;
      continue;
    }
    const float* const at = raw_.data() + source.index;
    const float a = at[0], b = at[1], c = at[width], d = at[width + 1];
    const float right = kUnit * source.right;
    const float down = kUnit * source.down;
    const float least = std::min(std::min(a, b), std::min(c, d));
    const float largest = std::max(std::max(a, b), std::max(c, d));
    if (largest <= kSmooth * least) {
      const float upper = a + right * (b - a);
      const float lower = c + right * (d - c);
      rectified_[i] = upper + down * (lower - upper);
    } else {
      rectified_[i] = at[(source.right >= 128 ? 1 : 0) + (source.down >= 128 ? width : 0)];
    }
  }
  return viewOf(rectified_.data(), width_, height_);
}

}  // namespace line_plane_segmentation
