// SPDX-License-Identifier: BSD-3-Clause
// Error of fused planes in simulated rooms, whose planes are known exactly, compared with that of the last
// image alone.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <optional>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/plane_track_filter.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "simulated_camera.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

constexpr int kImages = 10;
constexpr int kStarts = 3;  // in each room
constexpr double kMinPurity = 0.98;

// True plane of each segmented plane, if nearly all of its pixels belong to one.
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

// Root mean square of the errors of many planes.
struct Errors {
  double squared_degrees = 0.0, squared_millimetres = 0.0;
  int count = 0;

  void add(const Eigen::Vector3d& normal, double d, const simulation::WorldPlane& truth,
           const Eigen::Vector3d& point) {
    const double angle = std::atan2(normal.cross(truth.normal()).norm(), normal.dot(truth.normal()));
    squared_degrees += std::pow(angle * 180.0 / M_PI, 2);
    squared_millimetres += std::pow(1000.0 * (normal.dot(truth.projection(point)) + d), 2);
    ++count;
  }
  double degrees() const { return std::sqrt(squared_degrees / count); }
  double millimetres() const { return std::sqrt(squared_millimetres / count); }
};

struct Track {
  PlaneTrackFilter filter;
  std::optional<std::uint16_t> truth;  // empty once an image shows another plane, or several as one
};

struct Setting {
  std::uint64_t rooms;
  std::uint32_t min_pixels;  // of the planes that are compared, in the last image
  int width;
  double rate;                       // [Hz]
  double pose_degrees, pose_metres;  // standard deviations of the error of the pose in each image
  FusionParameters parameters;
};

struct Comparison {
  Errors single, fused;
};

Eigen::Isometry3d withError(const Eigen::Isometry3d& pose, const Setting& setting, Random& random) {
  const auto vector = [&] {
    return Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian());
  };
  const Eigen::Vector3d turn = setting.pose_degrees * M_PI / 180.0 * vector();
  Eigen::Isometry3d result = pose;
  if (turn.norm() > 0.0) {
    result.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * pose.linear();
  }
  result.translation() += setting.pose_metres * vector();
  return result;
}

// Fuses the images of one walk and compares the planes that were seen in each of them.
void compare(simulation::SimulatedCamera& camera, int start, const Setting& setting, Comparison& comparison) {
  const int height = setting.width * 3 / 4;
  std::vector<std::uint16_t> depth(static_cast<std::size_t>(setting.width * height));
  Random random(camera.options().seed * 100 + static_cast<std::uint64_t>(start));
  PlaneSegmenter segmenter;
  PlaneTracker tracker;
  std::map<std::uint32_t, Track> tracks;
  std::optional<Eigen::Isometry3d> last_pose;
  CameraVelocity velocity;
  for (int image = 0; image < kImages; ++image) {
    const double seconds = 7.0 * start + image / setting.rate;
    const auto frame = static_cast<std::uint64_t>(1000 * start + image);
    const simulation::Rendering& rendering = camera.capture(frame, seconds, depth.data());
    const Eigen::Isometry3d pose = withError(camera.pose(seconds), setting, random);
    const Eigen::Isometry3d motion = last_pose ? pose.inverse() * *last_pose : Eigen::Isometry3d::Identity();
    const Segmentation& segmentation =
        segmenter.segment(viewOf(depth.data(), setting.width, height), camera.intrinsics());
    const std::vector<std::uint32_t>& ids =
        tracker.track(segmentation, camera.intrinsics(), seconds, last_pose ? &motion : nullptr);
    if (last_pose) velocity = CameraVelocity::between(*last_pose, pose, 1.0 / setting.rate);
    last_pose = pose;
    const auto truth = truthOf(segmentation, rendering.labels);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const SegmentedPlane& plane = segmentation.planes[k];
      const auto [track, is_new] = tracks.try_emplace(
          ids[k], Track{PlaneTrackFilter(plane, pose, setting.parameters, velocity), truth[k]});
      PlaneTrackFilter& filter = track->second.filter;
      if (!is_new) {
        filter.predict(1.0 / setting.rate, setting.parameters);
        filter.update(plane, pose, setting.parameters, velocity);
        if (truth[k] != track->second.truth) track->second.truth.reset();
      }
      if (plane.inliers < setting.min_pixels) continue;
      if (image != kImages - 1 || filter.observations() != kImages || !track->second.truth) continue;
      const simulation::WorldPlane& world = camera.room().scene.planes()[*truth[k] - std::size_t{1}];
      const Eigen::Vector3d normal = pose.linear() * plane.normal;
      const Eigen::Vector3d point = pose * plane.centroid;
      comparison.single.add(normal, plane.d - normal.dot(pose.translation()), world, point);
      comparison.fused.add(filter.normal(), filter.d(), world, point);
    }
  }
}

Comparison compareInRooms(const Setting& setting) {
  Comparison comparison;
  for (std::uint64_t room = 1; room <= setting.rooms; ++room) {
    simulation::SimulatedCamera camera({room, setting.width, setting.width * 3 / 4, true});
    for (int start = 0; start < kStarts; ++start) compare(camera, start, setting, comparison);
  }
  const Errors &single = comparison.single, &fused = comparison.fused;
  std::cout << fused.count << " planes, root mean square: single image " << single.degrees() << " deg, "
            << single.millimetres() << " mm; fused " << fused.degrees() << " deg, " << fused.millimetres()
            << " mm\n";
  return comparison;
}

FusionParameters exactPose() {
  FusionParameters parameters;
  parameters.fusion_pose_angle = parameters.fusion_pose_distance = parameters.fusion_timestamp_error = 0.0;
  parameters.fusion_drift_angle = parameters.fusion_drift_distance = 0.0;
  return parameters;
}

// With the default parameters, and poses as uncertain as these say.
TEST(FusionQuality, tenImagesHalveTheErrorOfOne) {
  const FusionParameters defaults;
  const auto [single, fused] =
      compareInRooms({10, 0, 640, 10.0, defaults.fusion_pose_angle, defaults.fusion_pose_distance, defaults});
  EXPECT_GT(fused.count, 60);
  EXPECT_LE(fused.degrees(), 0.5 * single.degrees());
  EXPECT_LE(fused.millimetres(), 0.5 * single.millimetres());
}

// The errors that remain are those of the segmentation. The camera moves by decimetres in these five seconds,
// so that they are different in each image. The distance has a bound of its own as well: one relative to the
// single image alone would reward inaccurate images. Small planes, few of which are seen in all images, would
// outweigh the others.
TEST(FusionQuality, tenImagesHalveTheErrorOfOneWithAnExactPose) {
  const auto [single, fused] = compareInRooms({40, 4000, 320, 2.0, 0.0, 0.0, exactPose()});
  EXPECT_GT(fused.count, 200);
  EXPECT_LE(fused.degrees(), 0.5 * single.degrees());
  EXPECT_LE(fused.millimetres(), 0.6 * single.millimetres());
  EXPECT_LE(fused.millimetres(), 0.3);
  EXPECT_LE(single.millimetres(), 0.65);
}

// Within a second the viewpoint hardly changes. Pixels at the border of a plane that belong to its
// neighbour then are the same in each image, and the error that they cause remains.
TEST(FusionQuality, imagesOfOneViewpointShareErrors) {
  const auto [single, fused] = compareInRooms({10, 0, 640, 10.0, 0.0, 0.0, exactPose()});
  EXPECT_GT(fused.count, 60);
  EXPECT_LT(fused.degrees(), single.degrees());
  EXPECT_LT(fused.millimetres(), single.millimetres());
}

}  // namespace
}  // namespace line_plane_segmentation
