// SPDX-License-Identifier: BSD-3-Clause
#include "output_checks.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace line_plane_segmentation {
namespace {

template <typename Point>
bool isFinite(const Point& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

bool isFinite(const geometry_msgs::Polygon& polygon) {
  for (const geometry_msgs::Point32& point : polygon.points) {
    if (!isFinite(point)) return false;
  }
  return true;
}

void expectFinite(const Plane& plane) {
  for (const double number : plane.coefficients.coef) EXPECT_TRUE(std::isfinite(number));
  for (const double number : plane.covariance) EXPECT_TRUE(std::isfinite(number));
  EXPECT_TRUE(isFinite(plane.centroid));
  EXPECT_TRUE(std::isfinite(plane.rms) && plane.rms >= 0.0F) << plane.rms;
  EXPECT_TRUE(std::isfinite(plane.area) && plane.area >= 0.0F) << plane.area;
  EXPECT_TRUE(isFinite(plane.outline));
  for (const geometry_msgs::Polygon& part : plane.other_parts) EXPECT_TRUE(isFinite(part));
  for (const geometry_msgs::Polygon& hole : plane.holes) EXPECT_TRUE(isFinite(hole));
}

// Pixels of each label, and in the end those of labels that there are not.
std::vector<std::size_t> countLabels(const sensor_msgs::Image& labels, std::size_t plane_count) {
  std::vector<std::size_t> count(plane_count + 2, 0);
  for (std::size_t i = 0; i + 1 < labels.data.size(); i += 2) {
    std::uint16_t label;
    std::memcpy(&label, labels.data.data() + i, sizeof label);
    ++count[std::min<std::size_t>(label, plane_count + 1)];
  }
  return count;
}

void expectSound(const PlaneArray& message, const sensor_msgs::Image& labels, std::size_t plane_count) {
  const std::size_t pixels = std::size_t{message.image_width} * message.image_height;
  ASSERT_EQ(pixels * sizeof(std::uint16_t), labels.data.size());
  EXPECT_EQ(message.image_width, labels.width);
  EXPECT_EQ(message.image_height, labels.height);
  const std::vector<std::size_t> count = countLabels(labels, plane_count);
  std::size_t assigned = 0;
  for (const Plane& plane : message.planes) {
    expectFinite(plane);
    const auto& n = plane.coefficients.coef;
    EXPECT_NEAR(1.0, std::hypot(n[0], n[1], n[2]), 1e-6);
    EXPECT_GT(plane.id, 0U);
    EXPECT_GT(plane.label, 0U);
    ASSERT_LE(plane.label, plane_count);
    EXPECT_LE(plane.orientation, Plane::SLANTED);
    EXPECT_EQ(count[plane.label], plane.inliers);
    assigned += plane.inliers;
  }
  EXPECT_EQ(pixels - count[0], assigned) << "pixels with the label of no plane";
  EXPECT_EQ(message.assigned_pixels, assigned);
  EXPECT_LE(message.assigned_pixels, message.valid_pixels);
  EXPECT_LE(message.valid_pixels, pixels);
}

void expectFinite(const visualization_msgs::MarkerArray& message) {
  for (const visualization_msgs::Marker& marker : message.markers) {
    EXPECT_TRUE(isFinite(marker.pose.position)) << marker.ns;
    EXPECT_TRUE(isFinite(marker.scale)) << marker.ns;
    for (const geometry_msgs::Point& point : marker.points) EXPECT_TRUE(isFinite(point)) << marker.ns;
  }
}

// A number that is missing is missing in all three, and everywhere where there is no depth.
void expectSound(const sensor_msgs::PointCloud2& cloud, const Segmentation& segmentation) {
  ASSERT_EQ(std::size_t{cloud.height} * cloud.row_step, cloud.data.size());
  ASSERT_EQ(segmentation.labels.size(), std::size_t{cloud.width} * cloud.height);
  std::uint32_t points = 0;
  std::uint32_t halves = 0;
  sensor_msgs::PointCloud2ConstIterator<float> xyz(cloud, "x");
  for (std::size_t i = 0; i < segmentation.labels.size(); ++i, ++xyz) {
    const bool is_missing = std::isnan(xyz[0]) && std::isnan(xyz[1]) && std::isnan(xyz[2]);
    const bool is_point = std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
    points += is_point ? 1 : 0;
    halves += is_missing == is_point ? 1 : 0;
  }
  EXPECT_EQ(0U, halves) << "points with some numbers that are not finite";
  EXPECT_EQ(segmentation.valid_pixels, points);
}

}  // namespace

void expectExplained(const Validation& input, const std::string& explanation) {
  EXPECT_EQ(input.accepted(), explanation.empty()) << nameOf(input.refusal) << explanation;
  EXPECT_LT(explanation.size(), 400U);
  EXPECT_EQ(std::string::npos, explanation.find('\n'));
  EXPECT_EQ(input.accepted(), !input.view.empty());
  EXPECT_TRUE(!input.accepted() || isUsable(input.camera));
}

void expectSoundMessages(FrameSegmenter& segmenter, const PublishedPlanes& published) {
  EXPECT_NE(0U, segmenter.header().frame_id.find('/')) << "tf2 refuses a leading slash";
  const SegmentedFrame frame = segmenter.result(published);
  const sensor_msgs::Image::Ptr labels = labelsImage(frame);
  expectSound(*planesMessage(frame), *labels, segmenter.segmentation().planes.size());
  expectSound(*coloredCloud(frame), segmenter.segmentation());
  EXPECT_EQ(3 * segmenter.segmentation().labels.size(), overlayImage(frame)->data.size());
  expectFinite(*planeMarkers(frame));
  expectFinite(*scanlineMarkers(frame, segmenter.lineSegments(), segmenter.candidates()));
}

}  // namespace line_plane_segmentation
