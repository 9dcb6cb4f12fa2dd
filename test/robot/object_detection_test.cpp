// SPDX-License-Identifier: BSD-3-Clause
#include "object_detection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

#include "line_plane_segmentation/orientation.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "simulation.h"

namespace line_plane_segmentation {
namespace {

using simulation::Scene;

struct Box {
  Eigen::Vector3d foot;  // [m] middle of its bottom in the world
  double yaw;            // [rad]
  Eigen::Vector3d size;  // [m]
};

constexpr double kTableHeight = 0.7;

// A room with a table; the camera looks down at it from 0.6 m above, one metre away.
class Objects : public testing::Test {
 protected:
  Objects() {
    scene_.addRectangle({-3, 0, 0}, {6, 0, 0}, {0, 4, 0});    // floor
    scene_.addRectangle({-3, 3.2, 0}, {6, 0, 0}, {0, 0, 3});  // wall
    add({{0.0, 1.4, kTableHeight - 0.03}, 0.0, {1.4, 0.8, 0.03}});
  }

  void add(const Box& box) {
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(box.foot) * Eigen::AngleAxisd(box.yaw, Eigen::Vector3d::UnitZ());
    scene_.addBox(pose, box.size);
  }

  void addToTable(double x, double y, double yaw, const Eigen::Vector3d& size) {
    boxes_.push_back({{x, 1.4 + y, kTableHeight}, yaw, size});
    add(boxes_.back());
  }

  const std::vector<DetectedObject>& detect(int width = 640, bool with_supports = true) {
    const int height = width * 3 / 4;
    const CameraIntrinsics camera = simulation::kinectIntrinsics(width, height);
    pose_ = simulation::lookingAlong({0.0, 0.3, 1.35}, M_PI / 2.0, -0.55, 0.0);
    simulation::Rendering rendering;
    render(scene_, pose_, camera, width, height, rendering);
    depth_.resize(rendering.depth.size());
    simulation::KinectNoise({}, 3).apply(rendering, camera, 1, depth_.data());
    const DepthView view = viewOf(depth_.data(), width, height);
    segmentation_ = segmenter_.segment(view, camera);

    std::vector<std::size_t> supports;
    const Eigen::Vector3d up = pose_.linear().transpose() * Eigen::Vector3d::UnitZ();
    for (std::size_t k = 0; k < segmentation_.planes.size() && with_supports; ++k) {
      if (orientationOf(segmentation_.planes[k].normal, up, 0.17) == Orientation::kHorizontalUp)
        supports.push_back(k);
    }
    const DepthRange range{0.3F, 10.0F};
    return detector_.detect({view, range, camera, segmentation_}, supports, parameters_, NoiseParameters());
  }

  // The only detected object whose box's centre lies within `box`; null if there is not exactly one.
  const DetectedObject* objectOf(const Box& box, const std::vector<DetectedObject>& objects) const {
    const DetectedObject* found = nullptr;
    for (const DetectedObject& object : objects) {
      const Eigen::Vector3d centre = pose_ * object.box.translation();
      const Eigen::Vector3d offset = Eigen::AngleAxisd(-box.yaw, Eigen::Vector3d::UnitZ()) *
                                     (centre - box.foot - Eigen::Vector3d(0, 0, 0.5 * box.size.z()));
      if ((offset.cwiseAbs() - 0.5 * box.size).maxCoeff() > 0.0) continue;
      if (found != nullptr) return nullptr;
      found = &object;
    }
    return found;
  }

  void expectAllBoxes(const std::vector<DetectedObject>& objects, double tolerance) const {
    EXPECT_EQ(boxes_.size(), objects.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Box& box = boxes_[i];
      const DetectedObject* object = objectOf(box, objects);
      ASSERT_NE(nullptr, object) << "box " << i;
      const double longer = std::max(box.size.x(), box.size.y()),
                   shorter = std::min(box.size.x(), box.size.y());
      EXPECT_NEAR(longer, object->size.x(), tolerance) << "box " << i;
      EXPECT_NEAR(shorter, object->size.y(), tolerance) << "box " << i;
      EXPECT_NEAR(box.size.z(), object->size.z(), tolerance) << "box " << i;
      EXPECT_NEAR(kTableHeight, heightOf(*object), 0.02) << "box " << i << " stands on the table";
      const Eigen::Vector3d top = pose_.linear() * object->box.linear() * Eigen::Vector3d::UnitZ();
      EXPECT_GT(top.z(), 0.999) << "upright";
      EXPECT_NEAR(1.0, object->box.linear().determinant(), 1e-6);
      EXPECT_GT(object->columns * object->rows, static_cast<int>(object->pixels) - 1);
    }
  }

  // [m] of its support in the world
  double heightOf(const DetectedObject& object) const {
    return (pose_ * segmentation_.planes[object.support].centroid).z();
  }

  Scene scene_;
  std::vector<Box> boxes_;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  std::vector<std::uint16_t> depth_;
  PlaneSegmenter segmenter_;
  Segmentation segmentation_;
  ObjectDetector detector_;
  ObjectParameters parameters_;
};

TEST_F(Objects, findsEachBoxOnTheTable) {
  addToTable(-0.45, -0.1, 0.0, {0.16, 0.12, 0.2});
  addToTable(-0.1, 0.05, 0.4, {0.1, 0.15, 0.12});
  addToTable(0.3, -0.15, -0.3, {0.2, 0.1, 0.08});
  for (const int width : {640, 320}) {
    SCOPED_TRACE(width);
    expectAllBoxes(detect(width), 0.04);
  }
}

TEST_F(Objects, findsNoneOnAnEmptyTable) { EXPECT_TRUE(detect().empty()); }

TEST_F(Objects, findsNoneWithoutSupports) {
  addToTable(0.0, 0.0, 0.0, {0.2, 0.2, 0.2});
  EXPECT_TRUE(detect(640, false).empty());
}

TEST_F(Objects, findsAThinBook) {
  addToTable(0.0, 0.0, 0.2, {0.25, 0.18, 0.03});
  expectAllBoxes(detect(), 0.04);
}

TEST_F(Objects, assignsWhatStandsOnTheFloorToTheFloor) {
  add({{1.1, 2.0, 0.0}, 0.0, {0.3, 0.3, 0.3}});
  const std::vector<DetectedObject>& objects = detect();
  ASSERT_EQ(1U, objects.size());
  EXPECT_NEAR(0.0, heightOf(objects[0]), 0.03);
  EXPECT_NEAR(0.3, objects[0].size.z(), 0.04);
}

TEST_F(Objects, leavesOutWhatIsTooTall) {
  add({{0.1, 1.5, kTableHeight}, 0.2, {0.15, 0.15, 0.6}});
  EXPECT_TRUE(detect().empty());
  parameters_.max_object_height = 0.7;
  EXPECT_EQ(1U, detect().size());
}

// The table has the shape of an L, and a low wall stands in the notch of its hull.
TEST_F(Objects, leavesOutAWallOfWhichMostIsElsewhere) {
  scene_ = Scene();
  add({{-0.1, 1.2, kTableHeight - 0.03}, 0.0, {0.9, 0.4, 0.03}});
  add({{-0.25, 1.6, kTableHeight - 0.03}, 0.0, {0.6, 0.4, 0.03}});
  add({{1.57, 1.92, 0.0}, 0.0, {3.0, 1.0, 0.9}});
  addToTable(-0.2, -0.2, 0.2, {0.2, 0.1, 0.15});
  expectAllBoxes(detect(), 0.04);
}

TEST_F(Objects, goesByItsBounds) {
  addToTable(0.2, 0.0, 0.0, {0.15, 0.15, 0.1});
  ASSERT_EQ(1U, detect().size());
  parameters_.min_object_pixels = static_cast<int>(detect()[0].pixels) + 1;
  EXPECT_TRUE(detect().empty());
  parameters_ = {};
  parameters_.min_object_height = 0.2;
  EXPECT_TRUE(detect().empty());
  parameters_ = {};
  parameters_.min_support_area = 50.0;
  EXPECT_TRUE(detect().empty());
}

TEST_F(Objects, givesTheSameForTheSameInput) {
  addToTable(-0.2, 0.0, 0.3, {0.2, 0.1, 0.2});
  addToTable(0.3, 0.1, 0.3, {0.1, 0.1, 0.1});
  const std::vector<DetectedObject> first = detect(), second = detect();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].centroid, second[i].centroid);
    EXPECT_EQ(first[i].size, second[i].size);
  }
}

TEST_F(Objects, takesImagesOfEverySizeAndNoPlanes) {
  for (const int width : {1, 4, 40}) detect(width);
  scene_ = Scene();
  EXPECT_TRUE(detect().empty());
}

}  // namespace
}  // namespace line_plane_segmentation
