// SPDX-License-Identifier: BSD-3-Clause
#include "lens_distortion.h"

#include <sensor_msgs/distortion_models.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>

namespace line_plane_segmentation {
namespace {

constexpr char kEquidistant[] = "equidistant";  // sensor_msgs of 2020 and before has no constant for it
constexpr std::array<std::size_t, 5> kCounts = {4, 5, 8, 12, 14};  // of coefficients, in OpenCV

}  // namespace

std::optional<LensDistortion> LensDistortion::fromCameraInfo(const sensor_msgs::CameraInfo& info) {
  namespace models = sensor_msgs::distortion_models;
  LensDistortion lens;
  lens.is_fisheye_ = info.distortion_model == kEquidistant;
  const bool is_polynomial =
      info.distortion_model == models::PLUMB_BOB || info.distortion_model == models::RATIONAL_POLYNOMIAL;
  const bool is_finite = std::all_of(info.D.begin(), info.D.end(), [](double d) { return std::isfinite(d); });
  if (!is_finite || (!lens.is_fisheye_ && !is_polynomial)) return {};
  if (lens.is_fisheye_ ? info.D.size() < 4
                       : std::find(kCounts.begin(), kCounts.end(), info.D.size()) == kCounts.end()) {
    return {};
  }
  lens.coefficients_ = info.D;
  if (lens.is_fisheye_) lens.coefficients_.resize(4);
  return lens;
}

std::vector<cv::Point2d> LensDistortion::project(const std::vector<cv::Point2d>& points,
                                                 const CameraIntrinsics& camera) const {
  const cv::Matx33d k(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  std::vector<cv::Point2d> pixels;
  if (is_fisheye_) {
    cv::fisheye::distortPoints(points, pixels, k, coefficients_);
    return pixels;
  }
  std::vector<cv::Point3d> rays;
  rays.reserve(points.size());
  for (const cv::Point2d& point : points) rays.emplace_back(point.x, point.y, 1.0);
  cv::projectPoints(rays, cv::Vec3d(), cv::Vec3d(), k, coefficients_, pixels);
  return pixels;
}

double LensDistortion::maxMonotonicRadius(const CameraIntrinsics& camera) const {
  constexpr int kSteps = 500;
  constexpr double kFarthest = 4.5;  // 77 degrees off the axis
  std::vector<cv::Point2d> points;
  for (int i = 0; i <= kSteps; ++i) points.emplace_back(kFarthest * i / kSteps, 0.0);
  const std::vector<cv::Point2d> pixels = project(points, camera);
  std::size_t i = 1;
  while (i < pixels.size() && pixels[i].x > pixels[i - 1].x) ++i;
  return points[i - 1].x;
}

}  // namespace line_plane_segmentation
