// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.h"

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl_conversions/pcl_conversions.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "line_plane_segmentation/palette.h"
#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

// A wall at 2 m, 8x4 pixels, of which one is NaN and one is 0. With planes, the left half is plane 1, the
// next quarter plane 2, the rest no plane.
class Conversions : public testing::Test {
 protected:
  static constexpr int kWidth = 8;
  static constexpr int kHeight = 4;

  Conversions() : depth_(kWidth * kHeight, 2.0F) {
    depth_[0] = std::numeric_limits<float>::quiet_NaN();
    depth_[7] = 0.0F;
    header_.stamp = ros::Time(12.5);
    header_.frame_id = kCameraFrame;
    segmentation_.width = kWidth;
    segmentation_.height = kHeight;
    segmentation_.labels.resize(kWidth * kHeight);
    segmentation_.valid_pixels = 30;
  }

  void addPlanes() {
    for (std::size_t i = 0; i < segmentation_.labels.size(); ++i) {
      const std::size_t u = i % kWidth;
      segmentation_.labels[i] = u < 4 ? 1 : u < 6 ? 2 : 0;
    }
    segmentation_.labels[0] = 0;
    addRing(0.0F);
    addRing(1.0F);
    addRing(2.0F);
    SegmentedPlane plane;
    plane.label = 1;
    plane.normal = Eigen::Vector3d(0.0, 0.0, -1.0);
    plane.d = 2.0;
    plane.centroid = Eigen::Vector3d(0.1, 0.2, 2.0);
    for (int i = 0; i < 16; ++i) plane.covariance(i / 4, i % 4) = i;
    plane.inliers = 15;
    plane.rms = 0.004;
    plane.area = 1.5;
    plane.first_ring = 0;
    plane.outer_ring_count = 2;
    plane.hole_count = 1;
    segmentation_.planes.push_back(plane);
    plane.label = 2;
    plane.inliers = 8;
    plane.first_ring = 3;
    plane.outer_ring_count = plane.hole_count = 0;
    segmentation_.planes.push_back(plane);
  }

  SegmentedFrame frame() {
    view_ = viewOf(depth_.data(), kWidth, kHeight);
    published_.header = header_;
    publishPlanes(segmentation_, ids_, up_, orientation_, published_);
    return {header_, view_, range_, camera_, segmentation_, published_, 7.5};
  }

  void addRing(float x) {
    segmentation_.rings.push_back({static_cast<int>(segmentation_.vertices.size()), 3});
    segmentation_.vertices.emplace_back(x, 0.0F, 2.0F);
    segmentation_.vertices.emplace_back(x, 1.0F, 2.0F);
    segmentation_.vertices.emplace_back(x + 0.5F, 0.0F, 2.0F);
  }

  void expectHeader(const std_msgs::Header& header) const {
    EXPECT_EQ(header_.stamp, header.stamp);
    EXPECT_EQ(header_.frame_id, header.frame_id);
  }

  std::vector<float> depth_;
  DepthView view_;
  std_msgs::Header header_;
  DepthRange range_{0.3F, 10.0F};
  CameraIntrinsics camera_ = testCamera(kWidth, kHeight);
  Segmentation segmentation_;
  std::vector<std::uint32_t> ids_ = {1, 2};
  std::optional<Eigen::Vector3d> up_;
  OrientationParameters orientation_;
  PublishedPlanes published_;
};

TEST_F(Conversions, holesNameTheirParts) {
  addPlanes();
  EXPECT_EQ(std::vector<std::uint32_t>{0}, planesMessage(frame())->planes[0].hole_parts);
  // The hole shrunk and moved into the second part.
  const Eigen::Vector3f middle =
      (segmentation_.vertices[3] + segmentation_.vertices[4] + segmentation_.vertices[5]) / 3.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    segmentation_.vertices[6 + i] = middle + 0.5F * (segmentation_.vertices[3 + i] - middle);
  }
  const PlaneArray::ConstPtr message = planesMessage(frame());
  EXPECT_EQ(std::vector<std::uint32_t>{1}, message->planes[0].hole_parts);
  EXPECT_TRUE(message->planes[1].hole_parts.empty());
}

TEST_F(Conversions, planesTellAll) {
  addPlanes();
  const PlaneArray::ConstPtr message = planesMessage(frame());
  expectHeader(message->header);
  EXPECT_EQ(8U, message->image_width);
  EXPECT_EQ(4U, message->image_height);
  EXPECT_EQ(30U, message->valid_pixels);
  EXPECT_EQ(23U, message->assigned_pixels);
  EXPECT_FLOAT_EQ(7.5F, message->processing_time);
  EXPECT_DOUBLE_EQ(0.0075, message->processing_seconds);
  ASSERT_EQ(2U, message->planes.size());

  const Plane& plane = message->planes[0];
  EXPECT_EQ(1U, plane.id);
  EXPECT_EQ(1U, plane.label);
  EXPECT_EQ(-1.0, plane.coefficients.coef[2]);
  EXPECT_EQ(2.0, plane.coefficients.coef[3]);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(static_cast<double>(i), plane.covariance[i]);
  EXPECT_EQ(0.1, plane.centroid.x);
  EXPECT_EQ(0.2, plane.centroid.y);
  EXPECT_EQ(2.0, plane.centroid.z);
  EXPECT_EQ(15U, plane.inliers);
  EXPECT_FLOAT_EQ(0.004F, plane.rms);
  EXPECT_FLOAT_EQ(1.5F, plane.area);
  EXPECT_EQ(Plane::UNKNOWN, plane.orientation);

  ASSERT_EQ(3U, plane.outline.points.size());
  EXPECT_EQ(0.0F, plane.outline.points[0].x);
  EXPECT_EQ(1.0F, plane.outline.points[1].y);
  ASSERT_EQ(1U, plane.other_parts.size());
  EXPECT_EQ(1.0F, plane.other_parts[0].points[0].x);
  ASSERT_EQ(1U, plane.holes.size());
  EXPECT_EQ(2.0F, plane.holes[0].points[0].x);

  EXPECT_EQ(2U, message->planes[1].label);
  EXPECT_TRUE(message->planes[1].outline.points.empty());
}

TEST_F(Conversions, noPlanesIsAMessageToo) {
  const PlaneArray::ConstPtr message = planesMessage(frame());
  expectHeader(message->header);
  EXPECT_TRUE(message->planes.empty());
  EXPECT_EQ(8U, message->image_width);
}

TEST_F(Conversions, labelsAreTheLabels) {
  addPlanes();
  const sensor_msgs::Image::ConstPtr image = labelsImage(frame());
  expectHeader(image->header);
  EXPECT_EQ("16UC1", image->encoding);
  EXPECT_EQ(8U, image->width);
  EXPECT_EQ(4U, image->height);
  EXPECT_EQ(16U, image->step);
  ASSERT_EQ(64U, image->data.size());
  EXPECT_EQ(0, std::memcmp(image->data.data(), segmentation_.labels.data(), 64));
}

TEST_F(Conversions, cloudIsReadByPcl) {
  addPlanes();
  ids_ = {7, 9};
  const sensor_msgs::PointCloud2::ConstPtr message = coloredCloud(frame());
  expectHeader(message->header);
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  pcl::fromROSMsg(*message, cloud);
  ASSERT_TRUE(cloud.isOrganized());
  ASSERT_EQ(8U, cloud.width);
  ASSERT_EQ(4U, cloud.height);
  EXPECT_FALSE(cloud.is_dense);
  EXPECT_EQ(message->row_step * message->height, message->data.size());

  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const pcl::PointXYZRGB& point = cloud.at(u, v);
      if (v == 0 && (u == 0 || u == 7)) {
        EXPECT_TRUE(std::isnan(point.x) && std::isnan(point.y) && std::isnan(point.z));
        continue;
      }
      EXPECT_FLOAT_EQ(static_cast<float>(2.0 * (u - camera_.cx) / camera_.fx), point.x);
      EXPECT_FLOAT_EQ(static_cast<float>(2.0 * (v - camera_.cy) / camera_.fy), point.y);
      EXPECT_FLOAT_EQ(2.0F, point.z);
      const Color expected = u < 4 ? colorOf(7) : u < 6 ? colorOf(9) : Color{150, 150, 150};
      EXPECT_EQ(expected.r, point.r) << u << ", " << v;
      EXPECT_EQ(expected.g, point.g) << u << ", " << v;
      EXPECT_EQ(expected.b, point.b) << u << ", " << v;
    }
  }
}

TEST_F(Conversions, depthOutOfRangeIsNoPoint) {
  depth_[10] = 20.0F;
  depth_[11] = 0.1F;
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  pcl::fromROSMsg(*coloredCloud(frame()), cloud);
  EXPECT_TRUE(std::isnan(cloud.at(2, 1).z));
  EXPECT_TRUE(std::isnan(cloud.at(3, 1).z));
  EXPECT_FALSE(std::isnan(cloud.at(4, 1).z));
}

TEST_F(Conversions, overlayTintsPlanesOnly) {
  addPlanes();
  const sensor_msgs::Image::ConstPtr image = overlayImage(frame());
  expectHeader(image->header);
  EXPECT_EQ("rgb8", image->encoding);
  EXPECT_EQ(24U, image->step);
  ASSERT_EQ(96U, image->data.size());
  const auto pixel = [&](std::size_t u, std::size_t v) {
    return image->data.data() + v * image->step + 3 * u;
  };
  EXPECT_EQ(0, pixel(0, 0)[0]) << "missing depth is black";
  EXPECT_EQ(0, pixel(0, 0)[2]);
  const std::uint8_t* grey = pixel(6, 1);
  EXPECT_GT(grey[0], 0);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[0], grey[2]);
  const Color red = colorOf(1);
  EXPECT_EQ((2 * grey[0] + 3 * red.r) / 5, pixel(1, 1)[0]);
  EXPECT_EQ((2 * grey[0] + 3 * red.g) / 5, pixel(1, 1)[1]);
  EXPECT_EQ((2 * grey[0] + 3 * red.b) / 5, pixel(1, 1)[2]);
}

TEST_F(Conversions, markersDrawEachPlane) {
  addPlanes();
  const visualization_msgs::MarkerArray::ConstPtr message = planeMarkers(frame());
  const auto& markers = message->markers;
  // Plane 2 has no outline.
  ASSERT_EQ(6U, markers.size());
  EXPECT_EQ(Marker::DELETEALL, markers[0].action);

  EXPECT_EQ("outlines", markers[1].ns);
  EXPECT_EQ(Marker::LINE_LIST, markers[1].type);
  EXPECT_EQ(3U * 3U * 2U, markers[1].points.size());
  EXPECT_EQ(markers[1].points[0].x, markers[1].points[5].x) << "the ring does not close";

  EXPECT_EQ("normals", markers[2].ns);
  ASSERT_EQ(2U, markers[2].points.size());
  EXPECT_EQ(2.0, markers[2].points[0].z);
  EXPECT_LT(markers[2].points[1].z, 2.0) << "the normal does not look at the camera";

  EXPECT_EQ("ids", markers[3].ns);
  EXPECT_EQ("1: 1.50 m^2", markers[3].text);
  EXPECT_EQ("2: 1.50 m^2", markers[5].text);
  for (const Marker& marker : markers) {
    expectHeader(marker.header);
    EXPECT_EQ(1.0, marker.pose.orientation.w);
    for (const auto& point : marker.points) EXPECT_TRUE(std::isfinite(point.x + point.y + point.z));
  }
}

TEST_F(Conversions, markersOfNoPlanesDeleteTheOldOnes) {
  const visualization_msgs::MarkerArray::ConstPtr message = planeMarkers(frame());
  const auto& markers = message->markers;
  ASSERT_EQ(1U, markers.size());
  EXPECT_EQ(Marker::DELETEALL, markers[0].action);
}

TEST(EmptyFrame, makesEmptyMessages) {
  const std_msgs::Header header;
  const DepthView depth;
  const DepthRange range;
  const CameraIntrinsics camera = testCamera(8, 4);
  const Segmentation segmentation;
  const PublishedPlanes published;
  const SegmentedFrame frame{header, depth, range, camera, segmentation, published};
  EXPECT_TRUE(planesMessage(frame)->planes.empty());
  EXPECT_TRUE(labelsImage(frame)->data.empty());
  EXPECT_TRUE(coloredCloud(frame)->data.empty());
  EXPECT_TRUE(overlayImage(frame)->data.empty());
}

TEST(Palette, colorsDiffer) {
  for (std::uint32_t id = 1; id <= 60; ++id) {
    for (std::uint32_t other = id + 1; other <= 60; ++other) {
      const Color a = colorOf(id);
      const Color b = colorOf(other);
      const int difference = std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
      EXPECT_GT(difference, other <= 20 ? 50 : 20) << id << ", " << other;
    }
  }
  EXPECT_EQ(colorOf(1).r, colorOf(61).r);
}

}  // namespace
}  // namespace line_plane_segmentation
