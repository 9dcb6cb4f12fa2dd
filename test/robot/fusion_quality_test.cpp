// SPDX-License-Identifier: BSD-3-Clause
// In simulated rooms, whose planes are known exactly: after ten images the error of a fused plane is at most
// half of that of a single image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/plane_track_filter.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "line_plane_segmentation/simulation/simulated_camera.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kImages = 10;
constexpr double kRate = 10.0;  // [Hz]
constexpr std::uint64_t kRooms = 6;
constexpr int kStarts = 3;
constexpr double kMinPurity = 0.98;

// The true plane of each segmented plane, if nearly all of its pixels are of one.
std::vector<std::optional<std::uint16_t>> truthOf(const Segmentation& segmentation,
                                                  const std::vector<std::uint16_t>& truth) {
  std::vector<std::map<std::uint16_t, std::uint32_t>> votes(segmentation.planes.size() + 1);
  for (std::size_t i = 0; i < truth.size(); ++i) ++votes[segmentation.labels[i]][truth[i]];
  std::vector<std::optional<std::uint16_t>> result(segmentation.planes.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    for (const auto& [label, count] : votes[k + 1]) {
      if (label != 0 && count >= kMinPurity * segmentation.planes[k].inliers) result[k] = label;
    }
  }
  return result;
}

struct Errors {
  std::vector<double> degrees, millimetres;

  void add(const Eigen::Vector3d& normal, double d, const simulation::WorldPlane& truth,
           const Eigen::Vector3d& point) {
    degrees.push_back(std::atan2(normal.cross(truth.normal()).norm(), normal.dot(truth.normal())) * 180.0 /
                      M_PI);
    millimetres.push_back(1000.0 * std::abs(normal.dot(truth.projection(point)) + d));
  }
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(FusionQuality, tenImagesHalveTheErrorOfOne) {
  FusionParameters parameters;
  parameters.fusion_pose_angle = parameters.fusion_pose_distance = 0.0;  // the simulated pose is exact
  PlaneSegmenter segmenter;
  Errors single, fused;
  std::vector<std::uint16_t> depth(std::size_t{kWidth} * kHeight);
  for (std::uint64_t room = 1; room <= kRooms; ++room) {
    simulation::SimulatedCamera camera({room, kWidth, kHeight, true});
    for (int start = 0; start < kStarts; ++start) {
      PlaneTracker tracker;
      std::map<std::uint32_t, PlaneTrackFilter> filters;
      for (int image = 0; image < kImages; ++image) {
        const double seconds = 7.0 * start + image / kRate;
        const auto frame = static_cast<std::uint64_t>(1000 * start + image);
        const simulation::Rendering& rendering = camera.capture(frame, seconds, depth.data());
        const Eigen::Isometry3d pose = camera.pose(seconds);
        const Eigen::Isometry3d motion = pose.inverse() * camera.pose(seconds - 1.0 / kRate);
        const Segmentation& segmentation =
            segmenter.segment(viewOf(depth.data(), kWidth, kHeight), camera.intrinsics());
        const std::vector<std::uint32_t>& ids =
            tracker.track(segmentation, camera.intrinsics(), seconds, &motion);
        const auto truth = truthOf(segmentation, rendering.labels);
        for (std::size_t k = 0; k < ids.size(); ++k) {
          const SegmentedPlane& plane = segmentation.planes[k];
          const auto [filter, is_new] = filters.try_emplace(ids[k], plane, pose, parameters);
          if (!is_new) {
            filter->second.predict(1.0 / kRate, parameters);
            filter->second.update(plane, pose, parameters);
          }
          if (image != kImages - 1 || filter->second.observations() != kImages || !truth[k]) continue;
          const simulation::WorldPlane& world = camera.room().scene.planes()[*truth[k] - std::size_t{1}];
          const Eigen::Vector3d normal = pose.linear() * plane.normal;
          const Eigen::Vector3d point = pose * plane.centroid;
          single.add(normal, plane.d - normal.dot(pose.translation()), world, point);
          fused.add(filter->second.normal(), filter->second.d(), world, point);
        }
      }
    }
  }
  for (const auto& [name, errors] : {std::pair{"single image", single}, std::pair{"fused", fused}}) {
    std::cout << name << ": median " << median(errors.degrees) << " deg, " << median(errors.millimetres)
              << " mm; root mean square " << rootMeanSquare(errors.degrees) << " deg, "
              << rootMeanSquare(errors.millimetres) << " mm\n";
  }
  for (std::size_t i = 0; i < fused.degrees.size(); ++i)
    if (getenv("VERBOSE")) printf("E %f %f  %f %f\n", single.degrees[i], single.millimetres[i], fused.degrees[i], fused.millimetres[i]);
  EXPECT_GT(fused.degrees.size(), 60U);
  EXPECT_LE(rootMeanSquare(fused.degrees), 0.5 * rootMeanSquare(single.degrees));
  EXPECT_LE(rootMeanSquare(fused.millimetres), 0.5 * rootMeanSquare(single.millimetres));
}

}  // namespace
}  // namespace line_plane_segmentation
