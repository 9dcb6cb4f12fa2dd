// SPDX-License-Identifier: BSD-3-Clause
// PlaneLocator as a whole: transforms determine frame, orientation and ids.
#include "plane_locator.h"

#include <gtest/gtest.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "support/synthetic_depth.h"
#include "support/walls.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

// A camera 1 m above the floor that turns about the vertical; z is up.
class Locator : public testing::Test {
 protected:
  enum : std::size_t { kFront, kLeft, kFloor };

  static Eigen::Isometry3d pose(double degrees) {
    Eigen::Isometry3d ahead = Eigen::Isometry3d::Identity();
    ahead.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // looks along the world's x axis
    return Eigen::Translation3d(0.0, 0.0, 1.0) *
           Eigen::AngleAxisd(degrees * M_PI / 180.0, Eigen::Vector3d::UnitZ()) * ahead;
  }

  void putTransform(double seconds, const Eigen::Isometry3d& camera_in_world) {
    geometry_msgs::TransformStamped message = tf2::eigenToTransform(camera_in_world);
    message.header.stamp = ros::Time(seconds);
    message.header.frame_id = "world";
    message.child_frame_id = "camera";
    ASSERT_TRUE(transforms_.setTransform(message, "test", false));
  }

  /// Renders an image and locates its planes.
  const PublishedPlanes& look(double seconds, double degrees) {
    std_msgs::Header header;
    header.stamp = ros::Time(seconds);
    header.frame_id = "camera";
    picture_ = pictureOf(walls_, pose(degrees), kinectCamera(kWidth, kHeight), kWidth, kHeight);
    locator_->setParameters(parameters_);
    poses_ = locator_->lookUp(header);
    return locator_->locate(picture_.segmentation, kinectCamera(kWidth, kHeight), header, poses_);
  }

  const PublishedPlane& planeOf(const PublishedPlanes& published, std::size_t wall) const {
    return published.planes.at(static_cast<std::size_t>(picture_.planeOf(wall)));
  }

  std::vector<Wall> walls_ = {{{4, -3, 0}, {0, 6, 0}, {0, 0, 3}},
                              {{0, 1.5, 0}, {4, 0, 0}, {0, 0, 3}},
                              {{0, -3, 0}, {4, 0, 0}, {0, 6, 0}}};
  WallPicture picture_;
  CameraPoses poses_;
  LocationParameters parameters_;
  tf2::BufferCore transforms_;
  std::optional<PlaneLocator> locator_ = PlaneLocator(transforms_);
};

TEST_F(Locator, asksTfForNothingByItself) {
  const PublishedPlanes& published = look(100.0, 0.0);
  EXPECT_FALSE(poses_.has(TransformLookup::Status::kLate));
  EXPECT_FALSE(poses_.has(TransformLookup::Status::kUnknown));
  EXPECT_EQ("camera", published.header.frame_id);
  EXPECT_TRUE(published.target_from_optical.isApprox(Eigen::Isometry3d::Identity()));
  for (const PublishedPlane& plane : published.planes) EXPECT_EQ(Orientation::kUnknown, plane.orientation);
}

TEST_F(Locator, givesPlanesInTheTargetFrame) {
  parameters_.frames.target_frame = "world";
  putTransform(100.0, pose(10.0));
  const PublishedPlanes& published = look(100.0, 10.0);
  ASSERT_TRUE(poses_.target.found());
  EXPECT_EQ("world", published.header.frame_id);
  EXPECT_EQ(ros::Time(100.0), published.header.stamp);
  const SegmentedPlane& floor = planeOf(published, kFloor).plane;
  EXPECT_LT((floor.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_NEAR(0.0, floor.d, 1e-9);
  EXPECT_NEAR(0.0, floor.centroid.z(), 1e-9);
  EXPECT_NEAR(4.0, planeOf(published, kFront).plane.d, 1e-9);
}

TEST_F(Locator, knowsFloorsFromWallsByGravity) {
  parameters_.frames.gravity_frame = "world";
  putTransform(100.0, pose(10.0));
  const PublishedPlanes& published = look(100.0, 10.0);
  EXPECT_EQ("camera", published.header.frame_id);
  EXPECT_EQ(Orientation::kHorizontalUp, planeOf(published, kFloor).orientation);
  EXPECT_EQ(Orientation::kVertical, planeOf(published, kFront).orientation);
  EXPECT_EQ(Orientation::kVertical, planeOf(published, kLeft).orientation);
}

TEST_F(Locator, goesOnWithoutGravity) {
  parameters_.frames.gravity_frame = parameters_.frames.fixed_frame = "world";
  const PublishedPlanes& published = look(100.0, 0.0);
  EXPECT_FALSE(poses_.has(TransformLookup::Status::kLate)) << "it would be waited for, forever and in vain";
  EXPECT_TRUE(poses_.has(TransformLookup::Status::kUnknown));
  ASSERT_EQ(3U, published.planes.size());
  for (const PublishedPlane& plane : published.planes) EXPECT_EQ(Orientation::kUnknown, plane.orientation);
}

TEST_F(Locator, saysWhatIsLate) {
  putTransform(100.0, pose(0.0));
  for (std::string FrameParameters::*frame :
       {&FrameParameters::target_frame, &FrameParameters::gravity_frame, &FrameParameters::fixed_frame}) {
    parameters_ = {};
    parameters_.frames.*frame = "world";
    look(100.0, 0.0);
    EXPECT_FALSE(poses_.has(TransformLookup::Status::kLate));
    look(100.1, 0.0);
    EXPECT_TRUE(poses_.has(TransformLookup::Status::kLate));
  }
}

TEST_F(Locator, fallsBackToTheNewestIfToldTo) {
  putTransform(100.0, pose(0.0));
  parameters_.frames.target_frame = parameters_.frames.gravity_frame = "world";
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(100.1);
  for (const std::string fallback : {kNoTransform, kLatestTransform}) {
    parameters_.frames.tf_fallback = fallback;
    locator_->setParameters(parameters_);
    CameraPoses poses = locator_->lookUp(header);
    ASSERT_FALSE(poses.target.found());
    locator_->fallBack(header, poses);
    EXPECT_EQ(fallback == kLatestTransform, poses.target.found());
    EXPECT_EQ(fallback == kLatestTransform, poses.gravity.found());
  }
}

// The camera turns by 25 degrees between images: without its motion, the wall would get a new id.
TEST_F(Locator, followsPlanesAlongTheMotionInTheFixedFrame) {
  putTransform(100.0, pose(0.0));
  putTransform(100.1, pose(25.0));
  for (const char* fixed_frame : {"world", ""}) {
    parameters_.frames.fixed_frame = fixed_frame;
    const bool known = parameters_.frames.any();
    const std::uint32_t left = planeOf(look(100.0, 0.0), kLeft).id;
    const std::uint32_t left_after = planeOf(look(100.1, 25.0), kLeft).id;
    EXPECT_EQ(known, left == left_after);
    look(1.0, 0.0);  // ids restart
  }
}

// Poses in different fixed frames have no common motion.
TEST_F(Locator, measuresMotionInOneFrame) {
  parameters_.frames.fixed_frame = "world";
  putTransform(100.0, pose(0.0));
  putTransform(100.1, pose(0.0));
  geometry_msgs::TransformStamped turned = tf2::eigenToTransform(pose(60.0));
  turned.header.frame_id = "map";
  turned.child_frame_id = "world";
  transforms_.setTransform(turned, "test", true);
  const std::uint32_t left = planeOf(look(100.0, 0.0), kLeft).id;
  parameters_.frames.fixed_frame = "map";
  EXPECT_EQ(left, planeOf(look(100.1, 0.0), kLeft).id);
}

// Rows 21 and 22.
TEST_F(Locator, countsIdsFromOneAgainWhenTheClockJumps) {
  for (const double jump : {-0.01, -500.0, 3600.0}) {
    SCOPED_TRACE(jump);
    locator_.emplace(transforms_);
    look(1000.0, 0.0);
    walls_[kFloor].there = false;
    look(1000.1, 0.0);
    walls_[kFloor].there = true;
    walls_[kFloor].corner.z() = 0.5;
    EXPECT_EQ(4U, planeOf(look(1000.2, 0.0), kFloor).id);
    walls_[kFloor].corner.z() = 0.0;
    std::vector<std::uint32_t> ids;
    for (const PublishedPlane& plane : look(1000.2 + jump, 0.0).planes) ids.push_back(plane.id);
    EXPECT_EQ((std::vector<std::uint32_t>{1, 2, 3}), ids);
  }
}

TEST_F(Locator, standsAnyStamp) {
  parameters_.frames.target_frame = parameters_.frames.fixed_frame = "world";
  putTransform(100.0, pose(0.0));
  for (const double seconds : {0.0, 0.0, 4294967295.0, 1.0, 4294967295.0}) {
    EXPECT_EQ(3U, look(seconds, 0.0).planes.size());
  }
}

}  // namespace
}  // namespace line_plane_segmentation
