// SPDX-License-Identifier: BSD-3-Clause
// Target frame and selection by orientation, and that all messages follow them.
#include "published_planes.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "conversions.h"
#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

// Four planes of one pixel at 2 m and one triangle each: a floor, a ceiling, a wall and a ramp. The camera
// looks along the world's x axis from 1 m above its origin.
class Published : public testing::Test {
 protected:
  Published() {
    image_header_.frame_id = kCameraFrame;
    published_.header.frame_id = "world";
    published_.target_from_optical.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    published_.target_from_optical.translation() << 0, 0, 1;
    segmentation_.width = 4;
    segmentation_.height = 1;
    segmentation_.labels = {1, 2, 3, 4};
    const Eigen::Vector3d normals[] = {
        {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, -std::sqrt(0.5), -std::sqrt(0.5)}};
    for (int k = 0; k < 4; ++k) {
      SegmentedPlane plane;
      plane.label = static_cast<std::uint16_t>(k + 1);
      plane.normal = normals[k];
      plane.d = 2.0;
      plane.centroid = -2.0 * plane.normal;
      plane.inliers = 10U + static_cast<unsigned>(k);
      plane.area = 1.0;
      plane.first_ring = k;
      plane.outer_ring_count = 1;
      segmentation_.rings.push_back({3 * k, 3});
      for (int i = 0; i < 3; ++i) {
        segmentation_.vertices.emplace_back(static_cast<float>(k), static_cast<float>(i), 2.0F);
      }
      segmentation_.planes.push_back(plane);
    }
  }

  void publish() { publishPlanes(segmentation_, {11, 12, 13, 14}, up_, parameters_, published_); }

  SegmentedFrame frame() {
    publish();
    return {image_header_, view_, range_, camera_, segmentation_, published_};
  }

  std::vector<Orientation> orientations() {
    publish();
    std::vector<Orientation> found;
    for (const PublishedPlane& plane : published_.planes) found.push_back(plane.orientation);
    return found;
  }

  std::vector<float> depth_ = {2.0F, 2.0F, 2.0F, 2.0F};
  DepthView view_ = viewOf(depth_.data(), 4, 1);
  DepthRange range_{0.3F, 10.0F};
  CameraIntrinsics camera_ = testCamera(4, 1);
  std_msgs::Header image_header_;
  Segmentation segmentation_;
  std::optional<Eigen::Vector3d> up_ = Eigen::Vector3d(0, -1, 0);
  OrientationParameters parameters_;
  PublishedPlanes published_;
};

constexpr Orientation kFloor = Orientation::kHorizontalUp;
constexpr Orientation kCeiling = Orientation::kHorizontalDown;
constexpr Orientation kWall = Orientation::kVertical;
constexpr Orientation kRamp = Orientation::kSlanted;

TEST_F(Published, knowsHowPlanesLie) {
  EXPECT_EQ((std::vector<Orientation>{kFloor, kCeiling, kWall, kRamp}), orientations());
  parameters_.orientation_tolerance = 45.1;
  EXPECT_NE(kRamp, orientations()[3]) << "the tolerance is in degrees";
}

TEST_F(Published, knowsNothingWithoutGravity) {
  up_.reset();
  EXPECT_EQ(std::vector<Orientation>(4, Orientation::kUnknown), orientations());
}

TEST_F(Published, leavesOutEachOrientationThatIsNotWanted) {
  const struct {
    bool OrientationParameters::*wanted;
    std::vector<Orientation> left;
  } cases[] = {
      {&OrientationParameters::publish_horizontal_up, {kCeiling, kWall, kRamp}},
      {&OrientationParameters::publish_horizontal_down, {kFloor, kWall, kRamp}},
      {&OrientationParameters::publish_vertical, {kFloor, kCeiling, kRamp}},
      {&OrientationParameters::publish_slanted, {kFloor, kCeiling, kWall}},
      {&OrientationParameters::publish_unknown, {kFloor, kCeiling, kWall, kRamp}},
  };
  for (const auto& c : cases) {
    parameters_ = {};
    parameters_.*c.wanted = false;
    EXPECT_EQ(c.left, orientations());
  }
  up_.reset();
  EXPECT_TRUE(orientations().empty()) << "publish_unknown is off";
}

TEST_F(Published, isInTheFrameThatIsWanted) {
  publish();
  const SegmentedPlane& floor = published_.planes[0].plane;
  EXPECT_EQ(11U, published_.planes[0].id);
  EXPECT_NEAR(1.0, floor.normal.z(), 1e-12);
  EXPECT_NEAR(1.0, floor.d, 1e-12) << "2 m below a camera at 1 m";
  EXPECT_NEAR(-1.0, floor.centroid.z(), 1e-12);
  ASSERT_EQ(12U, published_.vertices.size());
  // (3, 2, 2) in the optical frame is 2 m ahead, 3 m to the right and 2 m below.
  EXPECT_LT((published_.vertices[11] - Eigen::Vector3f(2.0F, -3.0F, -1.0F)).norm(), 1e-6F);
}

TEST_F(Published, isWhatTheMessagesTell) {
  parameters_.publish_horizontal_up = false;
  const PlaneArray::ConstPtr message = planesMessage(frame());
  EXPECT_EQ("world", message->header.frame_id);
  ASSERT_EQ(3U, message->planes.size());
  EXPECT_EQ(12U, message->planes[0].id);
  EXPECT_EQ(2U, message->planes[0].label) << "it stays the value in the label image";
  EXPECT_EQ(Plane::HORIZONTAL_DOWN, message->planes[0].orientation);
  EXPECT_EQ(-1.0, message->planes[0].coefficients.coef[2]);
  EXPECT_EQ(Plane::VERTICAL, message->planes[1].orientation);
  EXPECT_EQ(Plane::SLANTED, message->planes[2].orientation);
  EXPECT_FLOAT_EQ(2.0F, message->planes[2].outline.points[2].x);
  EXPECT_FLOAT_EQ(-3.0F, message->planes[2].outline.points[2].y);
  EXPECT_EQ(11U + 12U + 13U, message->assigned_pixels);

  const auto markers = planeMarkers(frame());
  ASSERT_EQ(10U, markers->markers.size());
  for (const auto& marker : markers->markers) EXPECT_EQ("world", marker.header.frame_id);
  EXPECT_FLOAT_EQ(-1.0F, static_cast<float>(markers->markers[1].points[0].y)) << "the ceiling's triangle";
}

TEST_F(Published, isWhatTheImagesShow) {
  parameters_.publish_vertical = false;
  const auto labels = labelsImage(frame());
  EXPECT_EQ(kCameraFrame, labels->header.frame_id) << "a picture is the camera's";
  std::vector<std::uint16_t> values(4);
  std::memcpy(values.data(), labels->data.data(), labels->data.size());
  EXPECT_EQ((std::vector<std::uint16_t>{1, 2, 0, 4}), values);

  const auto overlay = overlayImage(frame());
  EXPECT_EQ(kCameraFrame, overlay->header.frame_id);
  const auto is_grey = [&](std::size_t u) {
    return overlay->data[3 * u] == overlay->data[3 * u + 1] &&
           overlay->data[3 * u] == overlay->data[3 * u + 2];
  };
  EXPECT_TRUE(is_grey(2));
  EXPECT_FALSE(is_grey(0) || is_grey(1) || is_grey(3));
}

TEST_F(Published, isWhereTheCloudIs) {
  parameters_.publish_vertical = false;
  const auto cloud = coloredCloud(frame());
  EXPECT_EQ("world", cloud->header.frame_id);
  sensor_msgs::PointCloud2ConstIterator<float> xyz(*cloud, "x");
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> rgb(*cloud, "rgb");
  for (int u = 0; u < 4; ++u, ++xyz, ++rgb) {
    EXPECT_FLOAT_EQ(2.0F, xyz[0]);
    EXPECT_FLOAT_EQ(static_cast<float>(-2.0 * (u - camera_.cx) / camera_.fx), xyz[1]);
    EXPECT_FLOAT_EQ(1.0F, xyz[2]);
    EXPECT_EQ(u == 2, rgb[0] == rgb[1] && rgb[1] == rgb[2]) << "grey where no plane is published";
  }
}

}  // namespace
}  // namespace line_plane_segmentation
