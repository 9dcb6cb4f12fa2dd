// SPDX-License-Identifier: BSD-3-Clause
#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "depth_overlay.h"
#include "line_plane_segmentation/palette.h"

namespace line_plane_segmentation {
namespace {

constexpr double kFarOutside = 1e5;  // [px]

cv::Vec3b bgrOf(std::uint16_t label) {
  const Color color = colorOf(label);
  return {color.b, color.g, color.r};
}

// Blue and red exchanged, for OpenCV's order of channels.
std::vector<LabelTint> tintsOf(const std::vector<std::uint16_t>& labels) {
  const std::uint16_t largest =
      labels.empty() ? std::uint16_t{0} : *std::max_element(labels.begin(), labels.end());
  std::vector<LabelTint> tints(largest + std::size_t{1});
  for (std::uint32_t label = 1; label <= largest; ++label) {
    const Color color = colorOf(label);
    tints[label] = {true, {color.b, color.g, color.r}};
  }
  return tints;
}

// Projection of a point [px]; points behind the camera are projected far outside the image.
cv::Point2d project(const CameraIntrinsics& camera, const Eigen::Vector3d& point) {
  const double z = std::max(point.z(), 1e-9);
  const auto clamped = [](double pixel) { return std::min(std::max(pixel, -kFarOutside), kFarOutside); };
  return {clamped(camera.fx * point.x() / z + camera.cx), clamped(camera.fy * point.y() / z + camera.cy)};
}

void drawOutline(const Segmentation& segmentation, const SegmentedPlane& plane,
                 const CameraIntrinsics& camera, int thickness, cv::Mat& picture) {
  // OpenCV's drawing functions take fixed-point coordinates with this number of fractional bits.
  constexpr int kFractionBits = 4;
  const cv::Vec3b color = bgrOf(plane.label);
  const cv::Scalar light = 0.5 * (cv::Scalar(color[0], color[1], color[2]) + cv::Scalar::all(255));
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = segmentation.rings[plane.first_ring + r];
    std::vector<cv::Point> points;
    for (int i = 0; i < ring.vertex_count; ++i) {
      const auto& vertex = segmentation.vertices[ring.first_vertex + i];
      points.emplace_back((1 << kFractionBits) * project(camera, vertex.cast<double>()));
    }
    cv::polylines(picture, points, true, light, thickness, cv::LINE_AA, kFractionBits);
  }
}

// For each label the pixel nearest to its plane's centroid: the centroid itself may lie on another plane.
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
  // About as long as the plane is wide, at most a tenth of the image.
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

cv::Mat drawOverlay(const DepthView& depth, const Segmentation& segmentation,
                    const CameraIntrinsics& camera) {
  CV_Assert(depth.width == segmentation.width && depth.height == segmentation.height);
  const double scale = std::max(0.6, depth.width / 640.0);

  cv::Mat picture(depth.height, depth.width, CV_8UC3);
  drawDepthOverlay(depth, DepthRange{}, segmentation.labels.data(), tintsOf(segmentation.labels),
                   picture.data);
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
