// SPDX-License-Identifier: BSD-3-Clause
// How much a plane has to have in common with an earlier one; the rest of plane_tracker.h is tested in
// plane_tracker_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "line_plane_segmentation/plane_tracker.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

constexpr int kCell = 10;  // [px] the tracker takes a point from each cell of this size
constexpr int kColumns = 48, kRows = 36;
const CameraIntrinsics kCamera = kinectCamera(kColumns * kCell, kRows* kCell);

/// Columns first_column to last_column - 1, rows first_row to last_row - 1 of cells.
struct Cells {
  int first_column, last_column, first_row, last_row;
};

/// An image of planes, each in a rectangle of cells.
struct Picture : Segmentation {
  Picture() {
    width = kColumns * kCell;
    height = kRows * kCell;
    labels.resize(std::size_t{kColumns} * kRows * kCell * kCell);
  }

  /// Adds a plane at a depth [m] of the middle of `pivot`, about which it is turned by `yaw` [rad]. Without
  /// an area it is matched by its points alone.
  SegmentedPlane& add(const Cells& cells, double depth, double yaw, const Cells& pivot) {
    SegmentedPlane plane;
    plane.label = static_cast<std::uint16_t>(planes.size() + 1);
    for (int v = cells.first_row * kCell; v < cells.last_row * kCell; ++v) {
      for (int u = cells.first_column * kCell; u < cells.last_column * kCell; ++u)
        labels[static_cast<std::size_t>(v) * kColumns * kCell + static_cast<std::size_t>(u)] = plane.label;
    }
    const double u = 0.5 * kCell * (pivot.first_column + pivot.last_column);
    const double v = 0.5 * kCell * (pivot.first_row + pivot.last_row);
    plane.normal = {std::sin(yaw), 0.0, -std::cos(yaw)};
    plane.centroid = {depth * (u - kCamera.cx) / kCamera.fx, depth * (v - kCamera.cy) / kCamera.fy, depth};
    plane.d = -plane.normal.dot(plane.centroid);
    plane.area = 1e-6;
    planes.push_back(plane);
    return planes.back();
  }
  SegmentedPlane& add(const Cells& cells, double depth = 2.0, double yaw = 0.0) {
    return add(cells, depth, yaw, cells);
  }
};

/// A tracker of images a thirtieth of a second apart.
struct Tracker {
  PlaneTracker tracker;
  double seconds = 0.0;

  std::vector<std::uint32_t> idsOf(const Picture& picture) {
    return tracker.track(picture, kCamera, seconds += 1.0 / 30.0);
  }
  std::uint32_t idOf(const Picture& picture) { return idsOf(picture).front(); }
};

// Two planes of 100 points each. The second is turned, so that its coefficients alone do not match.
TEST(PlaneMatching, NeedsATwentiethOfThePointsInCommon) {
  const auto is_matched = [](int common) {
    Tracker tracker;
    Picture before, after;
    before.add({0, 5, 0, 20});
    after.add({4, 9, 20 - common, 40 - common}, 2.0, 0.35, {4, 5, 20 - common, 20});
    tracker.idOf(before);
    return tracker.idOf(after) == 1;
  };
  EXPECT_TRUE(is_matched(12)) << "12 of 188 points";
  EXPECT_FALSE(is_matched(8)) << "8 of 192 points";
}

// A plane covers two earlier ones. The normal of the first differs by 36 of the 45 degrees allowed.
TEST(PlaneMatching, WeighsCommonPointsByTheAgreementOfTheCoefficients) {
  const auto id_with = [](int rows) {
    Tracker tracker;
    Picture before, after;
    before.add({0, 2, 0, 20}, 2.0, 36.0 * M_PI / 180.0);  // 40 points
    before.add({2, 4, 0, rows});
    after.add({0, 4, 0, 20});
    tracker.idsOf(before);
    return tracker.idOf(after);
  };
  // The first one counts exp(-2 0.8²) = 0.28 of its points.
  EXPECT_EQ(id_with(8), 2U) << "0.4 as many points";
  EXPECT_EQ(id_with(3), 1U) << "0.15 as many points";
}

// A plane covers two earlier ones. The last image had only the second.
TEST(PlaneMatching, PrefersThePlaneThatWasJustSeen) {
  const auto id_with = [](int rows) {
    Tracker tracker;
    Picture first, second, both;
    first.add({0, 2, 0, 20}, 2.0, 0.15);  // 40 points
    second.add({2, 4, 0, rows}, 2.0, -0.15);
    both.add({0, 4, 0, 20});
    tracker.idOf(first);
    EXPECT_EQ(tracker.idOf(second), 2U);
    return tracker.idOf(both);
  };
  EXPECT_EQ(id_with(16), 2U) << "0.8 as many points";
  EXPECT_EQ(id_with(10), 1U) << "half as many: the first one fits much better";
}

/// Whether a plane is matched to one that it has no point in common with.
bool isMatchedByCoefficients(double degrees, const Eigen::Vector3d& shift) {
  constexpr double kArea = 0.04;  // [m²] so that planes within 0.4 m are compared
  Tracker tracker;
  Picture before, after;
  const Eigen::Vector3d centroid = before.add({0, 10, 0, 10}).centroid;
  before.planes[0].area = kArea;
  SegmentedPlane& plane = after.add({20, 30, 0, 10}, 2.0, degrees * M_PI / 180.0);
  plane.centroid = centroid + shift;
  plane.d = -plane.normal.dot(plane.centroid);
  plane.area = kArea;
  tracker.idOf(before);
  return tracker.idOf(after) == 1;
}

// A third of track_angle and of track_distance: 15 degrees, 3.3 % of the distance.
TEST(PlaneMatching, IsStricterWithoutCommonPoints) {
  EXPECT_TRUE(isMatchedByCoefficients(11.0, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(isMatchedByCoefficients(22.0, {0.0, 0.0, 0.0}));
  EXPECT_TRUE(isMatchedByCoefficients(0.0, {0.0, 0.0, 0.05}));
  EXPECT_FALSE(isMatchedByCoefficients(0.0, {0.0, 0.0, 0.11}));
}

TEST(PlaneMatching, ReachesTwiceThePlanesSizeWithoutCommonPoints) {
  EXPECT_TRUE(isMatchedByCoefficients(0.0, {0.3, 0.0, 0.0}));
  EXPECT_FALSE(isMatchedByCoefficients(0.0, {0.6, 0.0, 0.0}));
}

// At 0.9 of that distance a plane counts 1 / 1.9 = 0.53. An earlier plane at the same place is turned
// instead.
TEST(PlaneMatching, PrefersThePlaneNearbyWithoutCommonPoints) {
  const auto id_with = [](double degrees) {
    Tracker tracker;
    Picture before, after;
    SegmentedPlane& plane = after.add({20, 30, 0, 10});
    plane.area = 0.04;  // [m²] so that planes within 0.4 m are compared
    const auto add_at = [&](const Eigen::Vector3d& centroid, const Cells& cells, double yaw) {
      SegmentedPlane& earlier = before.add(cells, 2.0, yaw);
      earlier.centroid = centroid;
      earlier.d = -earlier.normal.dot(centroid);
    };
    add_at(plane.centroid, {0, 10, 0, 10}, degrees * M_PI / 180.0);
    add_at(plane.centroid + Eigen::Vector3d(0.36, 0.0, 0.0), {10, 20, 0, 10}, 0.0);
    tracker.idsOf(before);
    return tracker.idOf(after);
  };
  EXPECT_EQ(id_with(7.3), 1U) << "it counts 0.62";
  EXPECT_EQ(id_with(9.7), 2U) << "it counts 0.43";
}

TEST(PlaneMatching, RemembersThe128PlanesThatWereSeenLast) {
  Tracker tracker;
  Picture planes;
  for (int k = 0; k < 150; ++k) planes.add({k % 15, k % 15 + 1, k / 15, k / 15 + 1});
  tracker.idsOf(planes);
  tracker.idsOf({});
  std::vector<std::uint32_t> expected(150);
  std::iota(expected.begin(), expected.begin() + 22, 151U);
  std::iota(expected.begin() + 22, expected.end(), 23U);
  EXPECT_EQ(tracker.idsOf(planes), expected) << "the first 22 are forgotten";
}

// A plane that fills the image has 1728 points: two are remembered beside the one that is seen.
TEST(PlaneMatching, RemembersAtMost4096PointsOfPlanesThatAreNotSeen) {
  const auto id_after = [](std::size_t planes) {
    const std::vector<double> depths = {1.0, 1.5, 2.25, 3.4};
    Tracker tracker;
    const auto wall = [](double depth) {
      Picture picture;
      picture.add({0, kColumns, 0, kRows}, depth);
      return picture;
    };
    for (std::size_t i = 0; i < planes; ++i) EXPECT_EQ(tracker.idOf(wall(depths[i])), i + 1);
    return tracker.idOf(wall(depths[0]));
  };
  EXPECT_EQ(id_after(3), 1U);
  EXPECT_EQ(id_after(4), 5U) << "forgotten";
}

}  // namespace
}  // namespace line_plane_segmentation
