// SPDX-License-Identifier: BSD-3-Clause
#include "object_detection.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "support_plane.h"

namespace line_plane_segmentation {
namespace {

constexpr float kNoiseOfHeight = 3.0F;  // standard deviations
constexpr float kNoiseOfGap = 4.0F;

// A connected component of a plane belongs to objects if at least this fraction of its pixels stands on
// supports.
constexpr double kMinStandingFraction = 0.5;

// A component is too tall if this fraction of its pixels, or more, is above the height limit: fewer are
// noise.
constexpr double kMaxTallFraction = 0.02;

// Fraction of the points that the box's height may leave out: pixels at depth discontinuities mix two depths.
constexpr double kOutlierFraction = 0.005;

constexpr int kReferencePixels = 200;  // min_object_pixels at this width:
constexpr int kReferenceWidth = 640;

}  // namespace

struct ObjectDetector::Scratch {
  // Support per pixel: 0 = none, k = supports[k - 1], negative if the pixel is above the height
  // limit.
  std::vector<std::int16_t> support_of;
  std::vector<Eigen::Vector3f> points;  // in the optical frame
  std::vector<SupportPlane> supports;
  std::vector<std::uint8_t> visited;  // pixels whose component of a plane is decided
  std::vector<int> component;
  std::vector<cv::Point2f> footprint;
  std::vector<float> heights;

  std::int16_t supportOf(const Eigen::Vector3f& point, std::uint16_t label,
                         const ObjectParameters& parameters, float sigma) const;
  void classify(const DepthScene& scene, const ObjectParameters& parameters, const NoiseParameters& noise);
  template <typename Take>
  void flood(int seed, int width, int height, Take&& take);
  void collectPlane(int seed, const Segmentation& segmentation);
  void dropBackground(const Segmentation& segmentation);
  double collect(int seed, int width, int height, const ObjectParameters& parameters,
                 const NoiseParameters& noise);
  DetectedObject describe(const SupportPlane& support, int width);
};

std::int16_t ObjectDetector::Scratch::supportOf(const Eigen::Vector3f& point, std::uint16_t label,
                                                const ObjectParameters& parameters, float sigma) const {
  float lowest = 0.0F;
  std::int16_t result = 0;
  for (std::size_t k = 0; k < supports.size(); ++k) {
    const SupportPlane& support = supports[k];
    if (label == support.label) return 0;
    const Eigen::Vector3f local = support.plane_from_optical * point;
    // An error in depth moves the point along its ray.
    const float noise =
        kNoiseOfHeight * sigma * std::abs(support.plane_from_optical.linear().row(2).dot(point)) / point.z();
    const float surface = std::max(static_cast<float>(parameters.min_object_height), noise);
    if (local.z() < -surface || (result != 0 && local.z() >= lowest)) continue;
    if (!support.covers(local.x(), local.y())) continue;
    if (local.z() < surface) return 0;
    lowest = local.z();
    const auto code = static_cast<std::int16_t>(k + 1);
    result =
        lowest > static_cast<float>(parameters.max_object_height) ? static_cast<std::int16_t>(-code) : code;
  }
  return result;
}

void ObjectDetector::Scratch::classify(const DepthScene& scene, const ObjectParameters& parameters,
                                       const NoiseParameters& noise) {
  const int width = scene.segmentation.width;
  const CameraIntrinsics& camera = scene.camera;
  const std::size_t pixels = scene.segmentation.labels.size();
  support_of.assign(pixels, 0);
  points.resize(pixels);
  std::vector<float> depth(static_cast<std::size_t>(width));
  for (int v = 0; v < scene.segmentation.height; ++v) {
    loadRow(scene.depth, v, scene.range, depth.data());
    const auto y = static_cast<float>((v - camera.cy) / camera.fy);
    const std::size_t row = static_cast<std::size_t>(v) * depth.size();
    for (std::size_t u = 0; u < depth.size(); ++u) {
      const float z = depth[u];
      if (z <= 0.0F) continue;
      const auto x = static_cast<float>((static_cast<double>(u) - camera.cx) / camera.fx);
      points[row + u] = z * Eigen::Vector3f(x, y, 1.0F);
      const std::uint16_t label = scene.segmentation.labels[row + u];
      const auto sigma = static_cast<float>(noise.sigma(static_cast<double>(z)));
      support_of[row + u] = supportOf(points[row + u], label, parameters, sigma);
    }
  }
}

// Collects the pixels that are connected with `seed` in component.
// @param take  called as take(pixel, from) for each neighbour of a collected pixel, and first for the seed
//              itself; returns whether it is collected, which it may be only once
template <typename Take>
void ObjectDetector::Scratch::flood(int seed, int width, int height, Take&& take) {
  component.clear();
  const auto visit = [&](int pixel, int from) {
    if (take(static_cast<std::size_t>(pixel), static_cast<std::size_t>(from))) component.push_back(pixel);
  };
  visit(seed, seed);
  for (std::size_t k = 0; k < component.size(); ++k) {
    const int pixel = component[k], u = pixel % width, v = pixel / width;
    if (u > 0) visit(pixel - 1, pixel);
    if (u + 1 < width) visit(pixel + 1, pixel);
    if (v > 0) visit(pixel - width, pixel);
    if (v + 1 < height) visit(pixel + width, pixel);
  }
}

// Collects the pixels that have the label of `seed` and are connected with it.
void ObjectDetector::Scratch::collectPlane(int seed, const Segmentation& segmentation) {
  const std::uint16_t label = segmentation.labels[seed];
  flood(seed, segmentation.width, segmentation.height, [&](std::size_t pixel, std::size_t) {
    if (visited[pixel] != 0 || segmentation.labels[pixel] != label) return false;
    visited[pixel] = 1;
    return true;
  });
}

// Walls and furniture behind a table reach into the space above it. The top of an object may be part of the
// same plane as another surface, but is not connected with it.
void ObjectDetector::Scratch::dropBackground(const Segmentation& segmentation) {
  visited.assign(support_of.size(), 0);
  for (std::size_t i = 0; i < support_of.size(); ++i) {
    if (support_of[i] == 0 || segmentation.labels[i] == 0 || visited[i] != 0) continue;
    collectPlane(static_cast<int>(i), segmentation);
    const auto standing =
        std::count_if(component.begin(), component.end(), [&](int pixel) { return support_of[pixel] > 0; });
    if (static_cast<double>(standing) >= kMinStandingFraction * static_cast<double>(component.size()))
      continue;
    for (const int pixel : component) support_of[pixel] = 0;
  }
}

// Collects the pixels on the support of `seed` that are connected with it, and takes them out of support_of.
// Returns the fraction of them that is above the height limit.
double ObjectDetector::Scratch::collect(int seed, int width, int height, const ObjectParameters& parameters,
                                        const NoiseParameters& noise) {
  const int support = std::abs(support_of[seed]);
  int tall = 0;
  flood(seed, width, height, [&](std::size_t pixel, std::size_t from) {
    std::int16_t& code = support_of[pixel];
    if (std::abs(code) != support) return false;
    const float z = points[from].z();
    const float gap = std::max(static_cast<float>(parameters.object_gap),
                               kNoiseOfGap * static_cast<float>(noise.sigma(static_cast<double>(z))));
    if (std::abs(points[pixel].z() - z) > gap) return false;
    tall += code < 0 ? 1 : 0;
    code = 0;
    return true;
  });
  return static_cast<double>(tall) / static_cast<double>(component.size());
}

DetectedObject ObjectDetector::Scratch::describe(const SupportPlane& support, int width) {
  DetectedObject object;
  object.support = support.index;
  object.pixels = static_cast<std::uint32_t>(component.size());
  footprint.clear();
  heights.clear();
  int left = width, right = 0, top = component.front() / width, bottom = 0;
  for (const int pixel : component) {
    const Eigen::Vector3f& point = points[pixel];
    const Eigen::Vector3f local = support.plane_from_optical * point;
    object.centroid += point.cast<double>();
    footprint.emplace_back(local.x(), local.y());
    heights.push_back(local.z());
    left = std::min(left, pixel % width);
    right = std::max(right, pixel % width);
    top = std::min(top, pixel / width);
    bottom = std::max(bottom, pixel / width);
  }
  object.centroid /= object.pixels;
  object.first_column = left;
  object.first_row = top;
  object.columns = right - left + 1;
  object.rows = bottom - top + 1;

  const auto highest = heights.end() - 1 - static_cast<std::ptrdiff_t>(kOutlierFraction * object.pixels);
  std::nth_element(heights.begin(), highest, heights.end());
  const double height = static_cast<double>(*highest);
  const cv::RotatedRect rectangle = cv::minAreaRect(footprint);
  const bool is_wide = rectangle.size.width >= rectangle.size.height;
  const double yaw = static_cast<double>(rectangle.angle) * CV_PI / 180.0 + (is_wide ? 0.0 : 0.5 * CV_PI);
  const auto [shorter, longer] = std::minmax(rectangle.size.width, rectangle.size.height);
  object.size = Eigen::Vector3d(static_cast<double>(longer), static_cast<double>(shorter), height);
  const Eigen::Vector3d centre(static_cast<double>(rectangle.center.x),
                               static_cast<double>(rectangle.center.y), 0.5 * height);
  object.box = support.plane_from_optical.cast<double>().inverse() * Eigen::Translation3d(centre) *
               Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return object;
}

ObjectDetector::ObjectDetector() : scratch_(std::make_unique<Scratch>()) {}
ObjectDetector::~ObjectDetector() = default;

const std::vector<DetectedObject>& ObjectDetector::detect(const DepthScene& scene,
                                                          const std::vector<std::size_t>& supports,
                                                          const ObjectParameters& parameters,
                                                          const NoiseParameters& noise) {
  constexpr std::size_t kMaxSupports = 255;  // bounds the time; they come largest first
  Scratch& s = *scratch_;
  const Segmentation& segmentation = scene.segmentation;
  objects_.clear();
  supports_.clear();
  s.supports.clear();
  for (const std::size_t index : supports) {
    if (segmentation.planes[index].area < parameters.min_support_area) continue;
    if (s.supports.size() == kMaxSupports) break;
    supports_.push_back(index);
    s.supports.push_back(supportPlane(segmentation, index, scene.camera));
  }
  if (s.supports.empty()) return objects_;
  s.classify(scene, parameters, noise);
  s.dropBackground(segmentation);

  const int width = segmentation.width;
  const std::int64_t from_width =
      std::int64_t{kReferencePixels} * width * width / (kReferenceWidth * kReferenceWidth);
  const std::int64_t fewest =
      parameters.min_object_pixels > 0 ? parameters.min_object_pixels : std::max<std::int64_t>(1, from_width);
  for (std::size_t i = 0; i < s.support_of.size(); ++i) {
    if (s.support_of[i] == 0) continue;
    const auto support = static_cast<std::size_t>(std::abs(s.support_of[i]) - 1);
    const double tall = s.collect(static_cast<int>(i), width, segmentation.height, parameters, noise);
    if (tall > kMaxTallFraction || static_cast<std::int64_t>(s.component.size()) < fewest) continue;
    objects_.push_back(s.describe(s.supports[support], width));
  }
  std::stable_sort(objects_.begin(), objects_.end(),
                   [](const DetectedObject& a, const DetectedObject& b) { return a.pixels > b.pixels; });
  return objects_;
}

}  // namespace line_plane_segmentation
