// SPDX-License-Identifier: BSD-3-Clause
#include "refine/plane_measurement.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/principal_axes.h"
#include "support/random.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

/// An image with labels painted on it.
struct LabelledImage {
  CameraIntrinsics camera;
  DepthImage depth;
  ViewRays rays;
  Segmentation segmentation;

  explicit LabelledImage(const DepthImage& image)
      : camera(kinectCamera(image.width, image.height)),
        depth(image),
        rays(raysOf(camera, image.width, image.height)) {
    segmentation.labels.assign(image.z.size(), 0);
  }

  void paintLabel(std::uint16_t label, const Region& region) {
    for (int v = region.first_v; v < region.last_v; ++v) {
      for (int u = region.first_u; u < region.last_u; ++u) {
        if (depth.at(u, v) > 0.0F) segmentation.labels[depth.index(u, v)] = label;
      }
    }
  }

  const std::vector<SegmentedPlane>& measure(
      int label_count, double min_area = 0.0,
      const std::vector<std::optional<PlaneEstimate>>& estimates = {}) {
    LabelRuns runs;
    runs.scan(segmentation.labels, depth.width, depth.height);
    PlaneMeasurement().measure(depth, rays, camera, label_count, min_area, runs, segmentation, estimates);
    runs.write(segmentation.labels, depth.width);
    return segmentation.planes;
  }

  std::vector<Eigen::Vector3d> pointsOf(std::uint16_t label) const {
    std::vector<Eigen::Vector3d> points;
    for (int v = 0; v < depth.height; ++v) {
      for (int u = 0; u < depth.width; ++u) {
        if (segmentation.labels[depth.index(u, v)] == label) points.push_back(pointAt(depth, rays, u, v));
      }
    }
    return points;
  }
};

TEST(PlaneMeasurement, AgreesWithSingularValuesOfThePoints) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    LabelledImage image(randomScene(seed, 90, 70));
    image.paintLabel(1, {0, 45, 0, 33});
    image.paintLabel(2, {40, 90, 10, 70});
    image.paintLabel(3, {5, 30, 40, 65});
    for (const SegmentedPlane& plane : image.measure(3)) {
      const std::vector<Eigen::Vector3d> points = image.pointsOf(plane.label);
      const PrincipalAxes axes = principalAxesOf(points);
      EXPECT_EQ(plane.inliers, points.size()) << seed;
      EXPECT_LT((plane.centroid - axes.centroid).norm(), 1e-9) << seed;
      EXPECT_NEAR(plane.rms * plane.rms, axes.variances[2], 1e-12) << seed;
      EXPECT_NEAR(std::abs(plane.normal.dot(axes.normal)), 1.0, 1e-9) << seed;
      EXPECT_NEAR(plane.normal.dot(axes.centroid) + plane.d, 0.0, 1e-9) << seed;
      EXPECT_GT(plane.d, 0.0) << seed;
      EXPECT_TRUE(plane.covariance.allFinite()) << seed;
    }
  }
}

TEST(PlaneMeasurement, KnowsTheAreaOfARectangle) {
  // 0.5 m x 0.4 m about the optical axis, turned in both ways; each pixel whose ray meets it carries the
  // label.
  for (const double yaw : {0.0, 0.5, 1.0}) {
    for (const double pitch : {-0.6, 0.0}) {
      const Surface surface = surfaceAt(1.2, yaw, pitch);
      LabelledImage image(render(surface, kinectCamera(640, 480), 640, 480));
      const Eigen::Vector3d middle(0.0, 0.0, 1.2);
      const Eigen::Vector3d along = Eigen::Vector3d::UnitY().cross(surface.normal).normalized();
      const Eigen::Vector3d across = surface.normal.cross(along);
      for (int v = 0; v < 480; ++v) {
        for (int u = 0; u < 640; ++u) {
          const Eigen::Vector3d offset = pointAt(image.depth, image.rays, u, v) - middle;
          const bool inside = std::abs(offset.dot(along)) < 0.25 && std::abs(offset.dot(across)) < 0.2;
          if (inside) image.segmentation.labels[image.depth.index(u, v)] = 1;
        }
      }
      const std::vector<SegmentedPlane>& planes = image.measure(1);
      ASSERT_EQ(planes.size(), 1U);
      EXPECT_NEAR(planes[0].area, 0.2, 0.002) << yaw << ' ' << pitch;
      EXPECT_LT((planes[0].normal - surface.normal).norm(), 1e-5);
      EXPECT_NEAR(planes[0].d, surface.d, 1e-5);
    }
  }
}

TEST(PlaneMeasurement, TakesThreeDegreesOfFreedom) {
  LabelledImage image(render(surfaceAt(1.5), kinectCamera(64, 48), 64, 48));
  image.depth.row(20)[30] += 0.01F;
  image.paintLabel(1, {30, 32, 20, 23});
  PointMoments moments;
  for (const Eigen::Vector3d& point : image.pointsOf(1)) moments.add(point);
  ASSERT_EQ(moments.count, 6.0);
  PlaneFit fit;
  ASSERT_TRUE(fitPlane(moments, fit));
  const Eigen::Matrix4d expected = fit.covariance(moments, std::sqrt(fit.mean_square * 6.0 / (6.0 - 3.0)));
  EXPECT_LT((image.measure(1).at(0).covariance - expected).norm(), 1e-6 * expected.norm());
}

TEST(PlaneMeasurement, TellsHowFarThePlaneMayBeOff) {
  const Surface surface = surfaceAt(1.5, 0.3, 0.2);
  const NoiseParameters uniform{0.003, 0.0, 0.4};
  constexpr int kTrials = 400;
  double mean_square = 0.0;  // of d's error, in units of its standard deviation
  Random random(8);
  for (int trial = 0; trial < kTrials; ++trial) {
    LabelledImage image(render(surface, kinectCamera(64, 48), 64, 48));
    addNoise(uniform, 1.0, random, image.depth);
    image.paintLabel(1, {5, 50, 5, 40});
    const SegmentedPlane& plane = image.measure(1).at(0);
    mean_square += std::pow(plane.d - surface.d, 2) / plane.covariance(3, 3) / kTrials;
  }
  EXPECT_NEAR(mean_square, 1.0, 0.2);
}

TEST(PlaneMeasurement, DropsLabelsThatSpanNoPlaneAndMovesTheOthersDown) {
  Random random(9);
  DepthImage depth = render(surfaceAt(1.5, 0.3, 0.2), kinectCamera(64, 48), 64, 48);
  addNoise({}, 1.0, random, depth);
  LabelledImage image(depth);
  image.paintLabel(1, {0, 2, 0, 1});     // two pixels
  image.paintLabel(2, {0, 20, 10, 30});  // a plane
  // 3 has no pixels at all
  image.paintLabel(4, {20, 60, 2, 3});    // one row: a plane through the camera, seen edge-on
  image.paintLabel(5, {63, 64, 5, 40});   // one column
  image.paintLabel(6, {30, 60, 10, 40});  // a plane
  const std::vector<std::uint16_t> before = image.segmentation.labels;
  const std::vector<SegmentedPlane>& planes = image.measure(6);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].label, 1);
  EXPECT_EQ(planes[0].inliers, 400U);
  EXPECT_EQ(planes[1].label, 2);
  EXPECT_EQ(planes[1].inliers, 900U);
  EXPECT_EQ(image.segmentation.assigned_pixels, 1300U);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(image.segmentation.labels[i], before[i] == 2 ? 1 : before[i] == 6 ? 2 : 0);
  }
}

TEST(PlaneMeasurement, DropsAPlaneWhosePixelsLieBehindIt) {
  LabelledImage image(render(surfaceAt(1.5), kinectCamera(64, 48), 64, 48));
  image.paintLabel(1, {40, 60, 10, 30});
  PlaneEstimate estimate{Eigen::Vector3d::UnitX(), 0.5, Eigen::Matrix4d::Zero()};  // the pixels are at x > 0
  EXPECT_TRUE(image.measure(1, 0.0, {estimate}).empty());
  EXPECT_EQ(std::count(image.segmentation.labels.begin(), image.segmentation.labels.end(), 0), 64 * 48);
  image.paintLabel(1, {40, 60, 10, 30});
  estimate.normal = -Eigen::Vector3d::UnitZ();
  EXPECT_EQ(image.measure(1, 0.0, {estimate}).size(), 1U);
}

TEST(PlaneMeasurement, DropsPlanesUnderTheSmallestArea) {
  LabelledImage image(render(surfaceAt(1.5), kinectCamera(64, 48), 64, 48));
  image.paintLabel(1, {0, 10, 0, 10});
  image.paintLabel(2, {20, 60, 10, 40});
  const double small = image.measure(2).at(0).area, large = image.segmentation.planes.at(1).area;
  ASSERT_LT(small, large);
  const std::vector<SegmentedPlane>& planes = image.measure(2, 0.5 * (small + large));
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0].inliers, 1200U);
  EXPECT_EQ(image.segmentation.labels[image.depth.index(5, 5)], 0);
  EXPECT_EQ(image.segmentation.labels[image.depth.index(30, 20)], 1);
}

TEST(PlaneMeasurement, CountsNoPixelWithoutLabel) {
  LabelledImage image(render(surfaceAt(1.5, 0.2), kinectCamera(64, 48), 64, 48));
  image.paintLabel(1, {0, 64, 0, 48});
  for (int u = 10; u < 20; ++u) {
    image.depth.row(7)[u] = 0.0F;
    image.segmentation.labels[image.depth.index(u, 7)] = 0;
  }
  const std::vector<SegmentedPlane>& planes = image.measure(1);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0].inliers, 64U * 48U - 10U);
  EXPECT_LT(planes[0].rms, 1e-6);
  EXPECT_EQ(image.segmentation.labels[image.depth.index(15, 7)], 0);
}

TEST(PlaneMeasurement, OfNoLabelsIsEmpty) {
  LabelledImage image(render(surfaceAt(1.5), kinectCamera(64, 48), 64, 48));
  EXPECT_TRUE(image.measure(0).empty());
  EXPECT_EQ(image.segmentation.assigned_pixels, 0U);
  EXPECT_TRUE(image.measure(3).empty()) << "labels that no pixel carries";
  LabelledImage no_pixels(blankDepth(0, 0));
  EXPECT_TRUE(no_pixels.measure(0).empty());
}

TEST(PlaneMeasurement, DropsAPlaneThroughTheCamera) {
  const auto planes_at = [](double sine) {
    LabelledImage image(render(surfaceAt(2.0), kinectCamera(60, 40), 60, 40));
    image.paintLabel(1, {20, 40, 10, 30});
    const PlaneEstimate estimate = {-Eigen::Vector3d::UnitZ(), 2.0 * sine, Eigen::Matrix4d::Zero()};
    return image.measure(1, 0.0, {estimate}).size();
  };
  EXPECT_EQ(planes_at(0.7e-6), 0U);
  EXPECT_EQ(planes_at(1.5e-6), 1U);
}

}  // namespace
}  // namespace line_plane_segmentation
