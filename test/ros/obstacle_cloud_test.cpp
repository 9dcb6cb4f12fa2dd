// SPDX-License-Identifier: BSD-3-Clause
// The clouds' fields for labels and ids, and which points the cloud without planes has.
#include "obstacle_cloud.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/palette.h"
#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

// A pixel without a plane, one without a depth, and one of each of five planes at 2 m, seen by a level camera
// 1 m above the floor: floor, table, ceiling, wall, ramp.
class ObstacleCloud : public testing::Test {
 protected:
  ObstacleCloud() {
    header_.frame_id = kCameraFrame;
    published_.header.frame_id = kCameraFrame;
    gravity_from_optical_.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    gravity_from_optical_.translation().z() = 1.0;
    published_.poses.gravity_frame_is_set = true;
    published_.poses.gravity_from_optical = gravity_from_optical_;
    segmentation_.width = 7;
    segmentation_.height = 1;
    segmentation_.labels = {0, 0, 1, 2, 3, 4, 5};
    const double r = std::sqrt(0.5);
    addPlane({0, -1, 0}, {0, 1.03, 2});
    addPlane({0, -1, 0}, {0, 0.3, 2});
    addPlane({0, 1, 0}, {0, -1.5, 2});
    addPlane({0, 0, -1}, {0, 0, 2});
    addPlane({0, -r, -r}, {0, 1, 2});
  }

  void addPlane(const Eigen::Vector3d& normal, const Eigen::Vector3d& centroid) {
    SegmentedPlane plane;
    plane.label = static_cast<std::uint16_t>(segmentation_.planes.size() + 1);
    plane.normal = normal;
    plane.centroid = centroid;
    plane.d = -normal.dot(centroid);
    segmentation_.planes.push_back(plane);
  }

  SegmentedFrame frame() {
    std::optional<Eigen::Vector3d> up;
    if (published_.poses.gravity_from_optical) up = -Eigen::Vector3d::UnitY();
    publishPlanes(segmentation_, {11, 12, 13, 14, 15}, up, orientation_, published_);
    return {header_, view_, range_, camera_, segmentation_, published_};
  }

  // The id of each point in the cloud.
  std::vector<std::uint32_t> ids() {
    const sensor_msgs::PointCloud2::ConstPtr cloud = cloudWithoutPlanes(frame(), parameters_);
    EXPECT_EQ(1U, cloud->height);
    EXPECT_TRUE(cloud->is_dense);
    EXPECT_EQ(cloud->width * cloud->point_step, cloud->data.size());
    EXPECT_EQ(cloud->row_step, cloud->data.size());
    std::vector<std::uint32_t> result;
    for (sensor_msgs::PointCloud2ConstIterator<std::uint32_t> id(*cloud, "id"); id != id.end(); ++id) {
      result.push_back(*id);
    }
    return result;
  }

  std_msgs::Header header_;
  std::vector<float> depth_{2.0F, 0.0F, 2.0F, 2.0F, 2.0F, 2.0F, 2.0F};
  DepthView view_ = viewOf(depth_.data(), 7, 1);
  DepthRange range_;
  CameraIntrinsics camera_{100, 100, 3, 0};
  Eigen::Isometry3d gravity_from_optical_ = Eigen::Isometry3d::Identity();
  Segmentation segmentation_;
  PublishedPlanes published_;
  OrientationParameters orientation_;
  ObstacleParameters parameters_;
};

using Ids = std::vector<std::uint32_t>;

TEST_F(ObstacleCloud, leavesOutTheFloorAloneByDefault) { EXPECT_EQ((Ids{0, 12, 13, 14, 15}), ids()); }

TEST_F(ObstacleCloud, leavesOutAllPlanesWithoutAGravityFrame) {
  published_.poses = {};
  EXPECT_EQ(Ids{0}, ids());
}

TEST_F(ObstacleCloud, leavesOutNothingWhileGravityIsUnknown) {
  published_.poses.gravity_from_optical.reset();
  EXPECT_EQ((Ids{0, 11, 12, 13, 14, 15}), ids());
}

TEST_F(ObstacleCloud, leavesOutTheOrientationsThatAreChosen) {
  parameters_.remove_floor = false;
  EXPECT_EQ((Ids{0, 11, 12, 13, 14, 15}), ids());
  parameters_.remove_horizontal_up = true;
  EXPECT_EQ((Ids{0, 13, 14, 15}), ids());
  parameters_.remove_horizontal_down = true;
  EXPECT_EQ((Ids{0, 14, 15}), ids());
  parameters_.remove_vertical = true;
  EXPECT_EQ((Ids{0, 15}), ids());
  parameters_.remove_slanted = true;
  EXPECT_EQ(Ids{0}, ids());
}

TEST_F(ObstacleCloud, knowsTheFloorByItsHeight) {
  parameters_.floor_height = 0.7;
  EXPECT_EQ((Ids{0, 11, 13, 14, 15}), ids()) << "now the table is the floor";
  parameters_ = {};
  parameters_.floor_tolerance = 0.02;
  EXPECT_EQ((Ids{0, 11, 12, 13, 14, 15}), ids()) << "it is 3 cm below";
}

TEST_F(ObstacleCloud, leavesOutPlanesThatAreNotPublishedAsWell) {
  orientation_.publish_horizontal_up = orientation_.publish_vertical = false;
  EXPECT_EQ((Ids{0, 0, 13, 0, 15}), ids());
}

TEST_F(ObstacleCloud, hasTheSameFieldsAsTheColouredCloud) {
  const sensor_msgs::PointCloud2::ConstPtr obstacles = cloudWithoutPlanes(frame(), parameters_);
  const sensor_msgs::PointCloud2::ConstPtr cloud = coloredCloud(frame());
  EXPECT_EQ(cloud->fields, obstacles->fields);
  EXPECT_EQ(cloud->point_step, obstacles->point_step);
}

TEST_F(ObstacleCloud, colouredCloudCarriesLabelsAndIds) {
  const sensor_msgs::PointCloud2::ConstPtr cloud = coloredCloud(frame());
  ASSERT_EQ(6U, cloud->fields.size());
  EXPECT_EQ("rgb", cloud->fields[3].name);
  EXPECT_EQ(12U, cloud->fields[3].offset) << "as before there were labels";
  EXPECT_EQ(24U, cloud->point_step);
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(*cloud, "label"), id(*cloud, "id");
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> rgb(*cloud, "rgb");
  for (std::uint32_t u = 0; u < 7; ++u, ++label, ++id, ++rgb) {
    EXPECT_EQ(segmentation_.labels[u], *label);
    EXPECT_EQ(*label == 0 ? 0U : 10U + *label, *id);
    EXPECT_EQ(*label == 0 ? 150 : colorOf(*id).r, rgb[2]);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
