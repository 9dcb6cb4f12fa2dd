// SPDX-License-Identifier: BSD-3-Clause
// Against points that are moved one by one, and against the algebra of homogeneous coordinates.
#include "line_plane_segmentation/segmentation.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "support/random.h"

namespace line_plane_segmentation {
namespace {

Eigen::Vector3d randomVector(Random& random, double size) {
  return size *
         Eigen::Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
}

Eigen::Isometry3d randomTransform(Random& random) {
  const Eigen::Vector4d q = Eigen::Vector4d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                            random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  return Eigen::Translation3d(randomVector(random, 20.0)) * Eigen::Quaterniond(q).normalized();
}

/// A plane that the camera sees, with points of it.
SegmentedPlane randomPlane(Random& random, std::vector<Eigen::Vector3d>& points) {
  SegmentedPlane plane;
  plane.label = 3;
  plane.inliers = 1234;
  plane.rms = 0.004;
  plane.area = 2.5;
  plane.first_ring = 5;
  plane.outer_ring_count = 2;
  plane.hole_count = 1;
  plane.normal = (randomVector(random, 1.0) - 1.5 * Eigen::Vector3d::UnitZ()).normalized();
  plane.d = random.uniform(0.5, 5.0);
  const Eigen::Vector3d foot = -plane.d * plane.normal;
  const Eigen::Vector3d x = plane.normal.unitOrthogonal(), y = plane.normal.cross(x);
  for (int i = 0; i < 10; ++i) {
    points.push_back(foot + random.uniform(-2.0, 2.0) * x + random.uniform(-2.0, 2.0) * y);
    plane.centroid += points.back() / 10.0;
  }
  Eigen::Matrix4d root;
  for (int i = 0; i < 16; ++i) root(i / 4, i % 4) = random.uniform(-0.01, 0.01);
  plane.covariance = root * root.transpose();
  return plane;
}

TEST(Transformed, HoldsTheMovedPointsAndLooksAtTheMovedCamera) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Eigen::Vector3d> points;
    const SegmentedPlane plane = randomPlane(random, points);
    const Eigen::Isometry3d target_from_optical = randomTransform(random);
    const SegmentedPlane moved = transformed(plane, target_from_optical);

    EXPECT_NEAR(moved.normal.norm(), 1.0, 1e-12);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
      EXPECT_NEAR(moved.normal.dot(target_from_optical * point) + moved.d, 0.0, 1e-12);
      mean += target_from_optical * point / 10.0;
    }
    EXPECT_NEAR((moved.centroid - mean).norm(), 0.0, 1e-12);
    const Eigen::Vector3d camera = target_from_optical.translation();
    EXPECT_NEAR(moved.normal.dot(camera) + moved.d, plane.d, 1e-12) << "the camera is before it, as far away";
  }
}

// A homogeneous plane goes with the inverse transpose of what points go with, and so does its covariance.
TEST(Transformed, HasTheCovarianceOfTheTransposedInverse) {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    std::vector<Eigen::Vector3d> points;
    const SegmentedPlane plane = randomPlane(random, points);
    const Eigen::Isometry3d target_from_optical = randomTransform(random);
    const Eigen::Matrix4d map = target_from_optical.matrix().inverse().transpose();
    const Eigen::Matrix4d expected = map * plane.covariance * map.transpose();
    const Eigen::Matrix4d covariance = transformed(plane, target_from_optical).covariance;
    EXPECT_LT((covariance - expected).norm(), 1e-10 * expected.norm());
  }
}

TEST(Transformed, LeavesAllElseAsItIs) {
  Random random(3);
  std::vector<Eigen::Vector3d> points;
  const SegmentedPlane plane = randomPlane(random, points);
  const SegmentedPlane moved = transformed(plane, randomTransform(random));
  EXPECT_EQ(moved.label, plane.label);
  EXPECT_EQ(moved.inliers, plane.inliers);
  EXPECT_EQ(moved.rms, plane.rms);
  EXPECT_EQ(moved.area, plane.area);
  EXPECT_EQ(moved.first_ring, plane.first_ring);
  EXPECT_EQ(moved.outer_ring_count, plane.outer_ring_count);
  EXPECT_EQ(moved.hole_count, plane.hole_count);
}

TEST(Transformed, IsTheSamePlaneInTheSameFrame) {
  Random random(4);
  std::vector<Eigen::Vector3d> points;
  const SegmentedPlane plane = randomPlane(random, points);
  const SegmentedPlane same = transformed(plane, Eigen::Isometry3d::Identity());
  EXPECT_EQ(same.normal, plane.normal);
  EXPECT_EQ(same.d, plane.d);
  EXPECT_EQ(same.centroid, plane.centroid);
  EXPECT_EQ(same.covariance, plane.covariance);
}

}  // namespace
}  // namespace line_plane_segmentation
