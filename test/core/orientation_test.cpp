// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/orientation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <string>

namespace line_plane_segmentation {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// A unit vector at so many degrees from the z axis.
Eigen::Vector3d tilted(double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitY()) * Eigen::Vector3d::UnitZ();
}

Orientation ofTilt(double degrees, double tolerance_degrees) {
  return orientationOf(tilted(degrees), Eigen::Vector3d::UnitZ(), tolerance_degrees * kDegree);
}

TEST(OrientationOf, IsWithinItsToleranceAndNotBeyond) {
  const struct {
    double degrees;
    Orientation expected;
  } cases[] = {
      {0.0, Orientation::kHorizontalUp},     {9.9, Orientation::kHorizontalUp},
      {10.1, Orientation::kSlanted},         {45.0, Orientation::kSlanted},
      {79.9, Orientation::kSlanted},         {80.1, Orientation::kVertical},
      {90.0, Orientation::kVertical},        {99.9, Orientation::kVertical},
      {100.1, Orientation::kSlanted},        {169.9, Orientation::kSlanted},
      {170.1, Orientation::kHorizontalDown}, {180.0, Orientation::kHorizontalDown},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(ofTilt(c.degrees, 10.0), c.expected)
        << c.degrees << " degrees: " << nameOf(ofTilt(c.degrees, 10.0));
    EXPECT_EQ(ofTilt(-c.degrees, 10.0), c.expected) << -c.degrees << " degrees";
  }
}

TEST(OrientationOf, FollowsAnyTolerance) {
  EXPECT_EQ(ofTilt(44.9, 45.0), Orientation::kHorizontalUp);
  EXPECT_EQ(ofTilt(45.1, 45.0), Orientation::kVertical);
  EXPECT_EQ(ofTilt(0.001, 0.0), Orientation::kSlanted);
  EXPECT_EQ(ofTilt(0.001, 0.0011), Orientation::kHorizontalUp);
  EXPECT_EQ(ofTilt(90.001, 0.0011), Orientation::kVertical);
}

TEST(OrientationOf, DependsOnTheAngleAlone) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  for (const double degrees : {3.0, 30.0, 88.0, 140.0, 177.0}) {
    EXPECT_EQ(orientationOf(turn * tilted(degrees), turn * Eigen::Vector3d::UnitZ(), 10.0 * kDegree),
              ofTilt(degrees, 10.0))
        << degrees;
  }
}

TEST(Orientations, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (int i = 0; i < kOrientationCount; ++i) names.insert(nameOf(static_cast<Orientation>(i)));
  EXPECT_EQ(names,
            (std::set<std::string>{"unknown", "horizontal_up", "horizontal_down", "vertical", "slanted"}));
}

}  // namespace
}  // namespace line_plane_segmentation
