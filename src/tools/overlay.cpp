// SPDX-License-Identifier: BSD-3-Clause
#include "overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace line_plane_segmentation {
namespace {

constexpr std::uint8_t kNoDepth = 24;
constexpr float kNearGrey = 235.0F;
constexpr float kFarGrey = 70.0F;

// Twenty colours that are told apart easily, BGR.
const cv::Vec3b& colorOf(std::uint16_t label) {
  static const std::array<cv::Vec3b, 20> kColors = {
      cv::Vec3b(60, 76, 231),   cv::Vec3b(113, 204, 46),  cv::Vec3b(219, 152, 52),  cv::Vec3b(15, 196, 241),
      cv::Vec3b(182, 89, 155),  cv::Vec3b(34, 126, 230),  cv::Vec3b(176, 190, 40),  cv::Vec3b(180, 105, 255),
      cv::Vec3b(35, 142, 107),  cv::Vec3b(160, 60, 60),   cv::Vec3b(120, 220, 210), cv::Vec3b(90, 60, 160),
      cv::Vec3b(235, 206, 135), cv::Vec3b(80, 127, 255),  cv::Vec3b(90, 140, 20),   cv::Vec3b(200, 140, 200),
      cv::Vec3b(40, 90, 140),   cv::Vec3b(170, 230, 130), cv::Vec3b(225, 105, 65),  cv::Vec3b(130, 130, 240)};
  return kColors[(label + kColors.size() - 1) % kColors.size()];
}

// Grey from near to far, without the nearest and farthest hundredth, which would take all the contrast.
cv::Mat greyOf(const cv::Mat& depth) {
  std::vector<std::uint16_t> sorted;
  sorted.reserve(depth.total());
  for (auto it = depth.begin<std::uint16_t>(); it != depth.end<std::uint16_t>(); ++it) {
    if (*it != 0) sorted.push_back(*it);
  }
  cv::Mat grey(depth.size(), CV_8UC1, cv::Scalar(kNoDepth));
  if (sorted.empty()) return grey;

  const auto quantile = [&sorted](std::size_t hundredths) {
    const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * hundredths / 100);
    std::nth_element(sorted.begin(), nth, sorted.end());
    return static_cast<float>(*nth);
  };
  const float near = quantile(1);
  const float span = std::max(quantile(99) - near, 1.0F);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const auto z = depth.at<std::uint16_t>(v, u);
      if (z == 0) continue;
      const float share = std::min(std::max((static_cast<float>(z) - near) / span, 0.0F), 1.0F);
      grey.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(kNearGrey + share * (kFarGrey - kNearGrey));
    }
  }
  return grey;
}

cv::Mat tint(const cv::Mat& grey, const std::vector<std::uint16_t>& labels) {
  constexpr float kColorShare = 0.6F;
  cv::Mat picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < grey.cols; ++u) {
      const std::size_t index =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(grey.cols) + static_cast<std::size_t>(u);
      if (labels[index] == 0) continue;
      const cv::Vec3b& color = colorOf(labels[index]);
      cv::Vec3b& pixel = picture.at<cv::Vec3b>(v, u);
      for (int c = 0; c < 3; ++c) {
        pixel[c] = cv::saturate_cast<std::uint8_t>(kColorShare * static_cast<float>(color[c]) +
                                                   (1.0F - kColorShare) * static_cast<float>(pixel[c]));
      }
    }
  }
  return picture;
}

class Projector {
 public:
  // Pixels in this many binary fractions, as OpenCV's drawing functions take them.
  static constexpr int kShift = 4;

  explicit Projector(const CameraIntrinsics& camera) : camera_(camera) {}

  cv::Point operator()(const Eigen::Vector3d& point) const {
    const double z = std::max(point.z(), 1e-9);
    const double u = camera_.fx * point.x() / z + camera_.cx;
    const double v = camera_.fy * point.y() / z + camera_.cy;
    return {toFixed(u), toFixed(v)};
  }

 private:
  static int toFixed(double pixel) {
    constexpr double kFarOutside = 1e5;
    return cvRound((1 << kShift) * std::min(std::max(pixel, -kFarOutside), kFarOutside));
  }

  CameraIntrinsics camera_;
};

void drawOutline(const Segmentation& segmentation, const SegmentedPlane& plane, const Projector& project,
                 int thickness, cv::Mat& picture) {
  const cv::Vec3b& color = colorOf(plane.label);
  const cv::Scalar light = 0.5 * (cv::Scalar(color[0], color[1], color[2]) + cv::Scalar::all(255));
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = segmentation.rings[static_cast<std::size_t>(plane.first_ring + r)];
    std::vector<cv::Point> points;
    for (int i = 0; i < ring.vertex_count; ++i) {
      points.push_back(
          project(segmentation.vertices[static_cast<std::size_t>(ring.first_vertex + i)].cast<double>()));
    }
    cv::polylines(picture, points, true, light, thickness, cv::LINE_AA, Projector::kShift);
  }
}

void drawNormal(const SegmentedPlane& plane, const Projector& project, double scale, cv::Mat& picture) {
  const cv::Point foot = project(plane.centroid);
  const cv::Point tip = project(plane.centroid + 0.12 * plane.centroid.z() * plane.normal);
  const int thickness = std::max(1, cvRound(scale));
  const auto inPixels = [](const cv::Point& p) {
    return cv::Point(p.x >> Projector::kShift, p.y >> Projector::kShift);
  };
  for (const bool border : {true, false}) {
    const cv::Scalar color = border ? cv::Scalar::all(0) : cv::Scalar::all(255);
    const int width = border ? thickness + 2 : thickness;
    cv::circle(picture, inPixels(foot), cvRound(2 * scale) + (border ? 1 : 0), color, cv::FILLED,
               cv::LINE_AA);
    cv::arrowedLine(picture, inPixels(foot), inPixels(tip), color, width, cv::LINE_AA, 0, 0.25);
    cv::putText(picture, std::to_string(plane.label),
                inPixels(foot) + cv::Point(cvRound(5 * scale), cvRound(14 * scale)), cv::FONT_HERSHEY_SIMPLEX,
                0.45 * scale, color, width, cv::LINE_AA);
  }
}

}  // namespace

cv::Mat drawOverlay(const cv::Mat& depth, const Segmentation& segmentation, const CameraIntrinsics& camera) {
  CV_Assert(depth.cols == segmentation.width && depth.rows == segmentation.height);
  const Projector project(camera);
  const double scale = std::max(0.6, depth.cols / 640.0);

  cv::Mat picture = tint(greyOf(depth), segmentation.labels);
  for (const SegmentedPlane& plane : segmentation.planes)
    drawOutline(segmentation, plane, project, std::max(1, cvRound(scale)), picture);
  for (const SegmentedPlane& plane : segmentation.planes) drawNormal(plane, project, scale, picture);
  return picture;
}

}  // namespace line_plane_segmentation
