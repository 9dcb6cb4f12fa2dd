// SPDX-License-Identifier: BSD-3-Clause
#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "line_plane_segmentation/ros/palette.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint8_t kNoDepth = 24;
constexpr float kNearGrey = 235.0F;
constexpr float kFarGrey = 70.0F;
constexpr double kFarOutside = 1e5;  // [px]

cv::Vec3b bgrOf(std::uint16_t label) {
  const Color color = colorOf(label);
  return {color.b, color.g, color.r};
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
      const cv::Vec3b color = bgrOf(labels[index]);
      cv::Vec3b& pixel = picture.at<cv::Vec3b>(v, u);
      for (int c = 0; c < 3; ++c) {
        pixel[c] = cv::saturate_cast<std::uint8_t>(kColorShare * static_cast<float>(color[c]) +
                                                   (1.0F - kColorShare) * static_cast<float>(pixel[c]));
      }
    }
  }
  return picture;
}

// Where a point is seen [px]; one that cannot be seen ends up far outside the picture.
cv::Point2d project(const CameraIntrinsics& camera, const Eigen::Vector3d& point) {
  const double z = std::max(point.z(), 1e-9);
  const auto clamped = [](double pixel) { return std::min(std::max(pixel, -kFarOutside), kFarOutside); };
  return {clamped(camera.fx * point.x() / z + camera.cx), clamped(camera.fy * point.y() / z + camera.cy)};
}

void drawOutline(const Segmentation& segmentation, const SegmentedPlane& plane,
                 const CameraIntrinsics& camera, int thickness, cv::Mat& picture) {
  // OpenCV draws at fractions of a pixel when it gets integers with so many binary digits after the point.
  constexpr int kFractionBits = 4;
  const cv::Vec3b color = bgrOf(plane.label);
  const cv::Scalar light = 0.5 * (cv::Scalar(color[0], color[1], color[2]) + cv::Scalar::all(255));
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = segmentation.rings[static_cast<std::size_t>(plane.first_ring + r)];
    std::vector<cv::Point> points;
    for (int i = 0; i < ring.vertex_count; ++i) {
      const auto& vertex = segmentation.vertices[static_cast<std::size_t>(ring.first_vertex + i)];
      points.emplace_back((1 << kFractionBits) * project(camera, vertex.cast<double>()));
    }
    cv::polylines(picture, points, true, light, thickness, cv::LINE_AA, kFractionBits);
  }
}

// For each label the pixel nearest its plane's centroid, which itself may lie on another plane.
std::vector<cv::Point> findAnchors(const Segmentation& segmentation, const CameraIntrinsics& camera) {
  struct Nearest {
    cv::Point2d centroid;
    cv::Point pixel;
    double distance = 1e300;
  };
  std::vector<Nearest> nearest;
  for (const SegmentedPlane& plane : segmentation.planes) {
    const cv::Point2d centroid = project(camera, plane.centroid);
    nearest.push_back({centroid, centroid});
  }
  for (std::size_t i = 0; i < segmentation.labels.size(); ++i) {
    const std::uint16_t label = segmentation.labels[i];
    if (label == 0 || label > nearest.size()) continue;
    Nearest& best = nearest[label - 1U];
    const cv::Point pixel(static_cast<int>(i) % segmentation.width, static_cast<int>(i) / segmentation.width);
    const cv::Point2d offset = cv::Point2d(pixel) - best.centroid;
    if (offset.dot(offset) < best.distance) best = {best.centroid, pixel, offset.dot(offset)};
  }
  std::vector<cv::Point> anchors;
  for (const Nearest& best : nearest) anchors.push_back(best.pixel);
  return anchors;
}

void drawNormal(const SegmentedPlane& plane, const cv::Point& foot, const CameraIntrinsics& camera,
                double scale, cv::Mat& picture) {
  // About as long as the plane is wide, but not too long, whatever the field of view.
  const double pixels = std::min(0.1 * picture.cols, 0.7 * std::sqrt(plane.inliers));
  const double metres = pixels * plane.centroid.z() / std::max(camera.fx, camera.fy);
  const Eigen::Vector3d above = plane.centroid + metres * plane.normal;
  const cv::Point arrow = project(camera, above) - project(camera, plane.centroid);
  const cv::Point text = foot + cv::Point(cvRound(5 * scale), cvRound(15 * scale));
  const int thickness = std::max(1, cvRound(scale));
  const auto draw = [&](const cv::Scalar& color, int border) {
    cv::circle(picture, foot, cvRound(2 * scale) + border / 2, color, cv::FILLED, cv::LINE_AA);
    cv::arrowedLine(picture, foot, foot + arrow, color, thickness + border, cv::LINE_AA, 0, 0.25);
    cv::putText(picture, std::to_string(plane.label), text, cv::FONT_HERSHEY_SIMPLEX, 0.5 * scale, color,
                thickness + border, cv::LINE_AA);
  };
  draw(cv::Scalar::all(0), 2);
  draw(cv::Scalar::all(255), 0);
}

}  // namespace

cv::Mat drawOverlay(const cv::Mat& depth, const Segmentation& segmentation, const CameraIntrinsics& camera) {
  CV_Assert(depth.cols == segmentation.width && depth.rows == segmentation.height);
  const double scale = std::max(0.6, depth.cols / 640.0);

  cv::Mat picture = tint(greyOf(depth), segmentation.labels);
  for (const SegmentedPlane& plane : segmentation.planes) {
    drawOutline(segmentation, plane, camera, std::max(1, cvRound(scale)), picture);
  }
  const std::vector<cv::Point> anchors = findAnchors(segmentation, camera);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    drawNormal(segmentation.planes[i], anchors[i], camera, scale, picture);
  }
  return picture;
}

}  // namespace line_plane_segmentation
